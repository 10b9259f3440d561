// What every call needs: statuses to exceptions, texts, handles that end themselves, progress and
// cancellation. C# 7. Calls of your own through TreeNative are written with it too, as in Tree.cs:
//
//     using (var call = new NativeCall(options))
//     {
//         tree_tree* made;
//         call.Check(TreeNative.tree_tree_grow_leaves(
//             (tree_tree*)call.Use(tree), null, IntPtr.Zero, null, 0, seed, call.Control, null, &made));
//         return new BotanicalTree(made);
//     }
using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using TreeFamily.Native;

namespace TreeFamily
{
    /// <summary>A call failed: the library's code, and its text of what was wrong and what would be right.</summary>
    public sealed class TreeException : Exception
    {
        /// <summary>One of TreeNative.TREE_ERROR_.</summary>
        public int Status { get; private set; }

        public TreeException(int status, string text) : base(text)
        {
            Status = status;
        }
    }

    /// <summary>How a call is done. All may be left out.</summary>
    public sealed class CallOptions
    {
        /// <summary>
        /// Told what is being done and the share of the whole that is done, 0 to 1; returns whether to go
        /// on. Called from the library's threads, for each call of the library one at a time. What it throws
        /// cancels the call and comes out of it as it is; unless all was done already, then it is dropped.
        /// </summary>
        public Func<string, float, bool> Progress;

        /// <summary>Cancels the call, which then throws OperationCanceledException.</summary>
        public CancellationToken Cancellation = CancellationToken.None;

        /// <summary>Caps; begin with TreeDefaults.Limits or TreeDefaults.LimitsForMemory.</summary>
        public tree_limits? Limits;

        /// <summary>Threads that do the work.</summary>
        public TreePool Pool;
    }

    /// <summary>An object of the library. Ends by Dispose, or when it is collected.</summary>
    public abstract class TreeHandle : SafeHandle
    {
        protected TreeHandle() : base(IntPtr.Zero, true) { }

        public override bool IsInvalid
        {
            get { return handle == IntPtr.Zero; }
        }

        /// <summary>Takes over what the library made.</summary>
        protected unsafe void Own(void* made)
        {
            SetHandle((IntPtr)made);
        }
    }

    /// <summary>IL2CPP knows it by its name, wherever it is declared.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        public MonoPInvokeCallbackAttribute(Type type) { }
    }

    /// <summary>
    /// One call, or several that belong together: keeps alive what the library is handed until it is
    /// disposed of, and makes exceptions of statuses. For one thread.
    /// </summary>
    public sealed unsafe class NativeCall : IDisposable
    {
        // IL2CPP has no delegates of instance methods for native code: one static method, and which call
        // it is comes in `user`. The field keeps the delegate alive.
        static readonly tree_progress_fn ProgressDelegate = OnProgress;
        static readonly IntPtr ProgressPointer =
            Marshal.GetFunctionPointerForDelegate(ProgressDelegate);

        readonly CallOptions options;
        readonly List<SafeHandle> used = new List<SafeHandle>();
        readonly List<IntPtr> blocks = new List<IntPtr>();
        CancellationTokenRegistration registration;
        CancelSwitch owned;
        GCHandle self;
        volatile ExceptionDispatchInfo thrown;

        /// <summary>What the library takes as `control`; NULL when there is nothing to say.</summary>
        public tree_control* Control { get; private set; }

        /// <summary>A call without progress, cancellation or limits.</summary>
        public NativeCall() : this(null) { }

        /// <summary>A call as the options say; null is the default.</summary>
        public NativeCall(CallOptions options)
        {
            TreeLibrary.CheckVersion();
            this.options = options;
            if (options == null)
            {
                return;
            }
            try
            {
                Fill();
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        void Fill()
        {
            Control = (tree_control*)Block(sizeof(tree_control));
            Check(TreeNative.tree_control_init(Control, (UIntPtr)sizeof(tree_control)));
            if (options.Progress != null)
            {
                self = GCHandle.Alloc(this);
                Control->progress = ProgressPointer;
                Control->user = (void*)GCHandle.ToIntPtr(self);
            }
            if (options.Limits.HasValue)
            {
                Control->limits = (tree_limits*)Block(sizeof(tree_limits));
                *Control->limits = options.Limits.Value;
            }
            if (options.Pool != null)
            {
                Control->pool = (tree_pool*)Use(options.Pool);
            }
            if (options.Cancellation.CanBeCanceled)
            {
                owned = new CancelSwitch();
                Control->cancel = (tree_cancel*)Use(owned);
                registration = options.Cancellation.Register(owned.Set);
            }
        }

        /// <summary>The handle's pointer; another thread's Dispose waits until this call is done.</summary>
        public void* Use(SafeHandle handle)
        {
            if (handle == null)
            {
                return null;
            }
            bool taken = false;
            handle.DangerousAddRef(ref taken);
            used.Add(handle);
            return (void*)handle.DangerousGetHandle();
        }

        /// <summary>Memory until the call is done, not cleared.</summary>
        public void* Block(int size)
        {
            IntPtr block = Marshal.AllocHGlobal(size);
            blocks.Add(block);
            return (void*)block;
        }

        /// <summary>UTF-8 with a NUL at its end, until the call is done; null is NULL.</summary>
        public byte* Text(string text)
        {
            if (text != null && text.IndexOf('\0') >= 0)
            {
                throw new ArgumentException("A text with a NUL in it.");
            }
            return text == null ? null : Str(text + '\0').data;
        }

        /// <summary>A text in a struct, until the call is done; null is empty.</summary>
        public tree_str Str(string text)
        {
            if (string.IsNullOrEmpty(text))
            {
                return new tree_str();
            }
            byte[] bytes = Encoding.UTF8.GetBytes(text);
            byte* block = (byte*)Block(bytes.Length);
            Marshal.Copy(bytes, 0, (IntPtr)block, bytes.Length);
            return new tree_str { data = block, len = (UIntPtr)bytes.Length };
        }

        /// <summary>A file that the library made in memory, copied; the library's own is freed.</summary>
        public byte[] Take(tree_bytes* made)
        {
            try
            {
                byte* data;
                UIntPtr length;
                Check(TreeNative.tree_bytes_view(made, &data, &length));
                return NativeText.Bytes(data, length);
            }
            finally
            {
                TreeNative.tree_bytes_free(made);
            }
        }

        /// <summary>Throws unless the status is TREE_OK.</summary>
        public void Check(int status)
        {
            if (status == TreeNative.TREE_OK)
            {
                return;
            }
            string text = NativeText.Read(TreeNative.tree_error_text());
            if (thrown != null)
            {
                // Not wrapped: awaiting code takes an OperationCanceledException for a wish, not a fault.
                thrown.Throw();
            }
            if (status == TreeNative.TREE_ERROR_CANCELLED)
            {
                throw options == null
                    ? new OperationCanceledException(text)
                    : new OperationCanceledException(text, options.Cancellation);
            }
            throw new TreeException(status, text);
        }

        public void Dispose()
        {
            // Waits for a Set that is under way: the switch is freed only then.
            registration.Dispose();
            foreach (SafeHandle handle in used)
            {
                handle.DangerousRelease();
            }
            if (owned != null)
            {
                owned.Dispose();
            }
            foreach (IntPtr block in blocks)
            {
                Marshal.FreeHGlobal(block);
            }
            if (self.IsAllocated)
            {
                self.Free();
            }
        }

        /// <summary>No exception may leave it: there is Rust above.</summary>
        [MonoPInvokeCallback(typeof(tree_progress_fn))]
        static int OnProgress(void* user, byte* stage, float fraction)
        {
            NativeCall call = null;
            try
            {
                call = (NativeCall)GCHandle.FromIntPtr((IntPtr)user).Target;
                return call.options.Progress(NativeText.Read(stage), fraction) ? 0 : 1;
            }
            catch (Exception error)
            {
                if (call != null)
                {
                    call.thrown = ExceptionDispatchInfo.Capture(error);
                }
                return 1;
            }
        }
    }

    /// <summary>The library's texts and bytes, copied.</summary>
    public static unsafe class NativeText
    {
        /// <summary>A text that ends with a NUL; NULL is empty.</summary>
        public static string Read(byte* text)
        {
            if (text == null)
            {
                return "";
            }
            int length = 0;
            while (text[length] != 0)
            {
                length++;
            }
            return Read(text, length);
        }

        /// <summary>A text of so many bytes.</summary>
        public static string Read(byte* text, int length)
        {
            return Encoding.UTF8.GetString(Bytes(text, (UIntPtr)checked((uint)length)));
        }

        /// <summary>A text in a struct.</summary>
        public static string Read(tree_str text)
        {
            return Encoding.UTF8.GetString(Bytes(text.data, text.len));
        }

        /// <summary>So many bytes.</summary>
        public static byte[] Bytes(void* from, UIntPtr length)
        {
            var bytes = new byte[checked((int)length)];
            if (bytes.Length > 0)
            {
                Marshal.Copy((IntPtr)from, bytes, 0, bytes.Length);
            }
            return bytes;
        }
    }
}
