# throw-away: GLSL master to WGSL and HLSL
import re,sys
def hlsl(s):
    s=re.sub(r'\bvec([234])\b',r'float\1',s)
    return s
def wgsl(s):
    def fn(m):
        ret,name,args=m.groups()
        ty=lambda t:{'float':'f32','int':'i32'}.get(t,re.sub(r'vec(\d)',r'vec\1<f32>',t))
        a=', '.join(f"{p.split()[1]}: {ty(p.split()[0])}" for p in args.split(', '))
        return f"fn {name}({a}) -> {ty(ret)} {{"
    out=[]
    for l in s.split('\n'):
        m=re.match(r'^(float|vec[234]) (tree_\w+)\((.*)\) \{$',l)
        if m: l=fn(m)
        else:
            l=re.sub(r'\bfloat (\w+) =',r'var \1: f32 =',l)
            l=re.sub(r'\bint (\w+) =',r'var \1: i32 =',l)
            l=re.sub(r'\bvec([234]) (\w+) =',r'var \2: vec\1<f32> =',l)
        out.append(l)
    return '\n'.join(out)
for n in ['cards','octahedral']:
    s=open(n+'.glsl').read()
    head,body=s.split('// ---\n',1)
    hs=open(n+'.head.hlsl').read(); ws=open(n+'.head.wgsl').read()
    open(n+'.hlsl','w').write(hs+'// ---\n'+hlsl(body)); open(n+'.wgsl','w').write(ws+'// ---\n'+wgsl(body))
