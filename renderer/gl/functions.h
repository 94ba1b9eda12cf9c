// The OpenGL 4.5 functions that Pelage uses, loaded through the context (never linked: see docs/headless-gl.md).
#pragma once

#include <GL/glcorearb.h>

#include <functional>
#include <string>

namespace pelage {

/// Looks a function up by name; null where the context has none.
using LoadFunction = std::function<void*(const char*)>;

/// A table of functions, valid for one context on one thread.
struct Gl {
  PFNGLATTACHSHADERPROC AttachShader = nullptr;
  PFNGLBINDBUFFERBASEPROC BindBufferBase = nullptr;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer = nullptr;
  PFNGLBINDTEXTUREUNITPROC BindTextureUnit = nullptr;
  PFNGLBINDVERTEXARRAYPROC BindVertexArray = nullptr;
  PFNGLBLENDEQUATIONPROC BlendEquation = nullptr;
  PFNGLBLENDFUNCPROC BlendFunc = nullptr;
  PFNGLBLITNAMEDFRAMEBUFFERPROC BlitNamedFramebuffer = nullptr;
  PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC CheckNamedFramebufferStatus = nullptr;
  PFNGLCLEARNAMEDFRAMEBUFFERFVPROC ClearNamedFramebufferfv = nullptr;
  PFNGLCLIENTWAITSYNCPROC ClientWaitSync = nullptr;
  PFNGLCLIPCONTROLPROC ClipControl = nullptr;
  PFNGLCOLORMASKPROC ColorMask = nullptr;
  PFNGLCOMPILESHADERPROC CompileShader = nullptr;
  PFNGLCOPYTEXTURESUBIMAGE3DPROC CopyTextureSubImage3D = nullptr;
  PFNGLCREATEBUFFERSPROC CreateBuffers = nullptr;
  PFNGLCREATEFRAMEBUFFERSPROC CreateFramebuffers = nullptr;
  PFNGLCREATEPROGRAMPROC CreateProgram = nullptr;
  PFNGLCREATERENDERBUFFERSPROC CreateRenderbuffers = nullptr;
  PFNGLCREATESHADERPROC CreateShader = nullptr;
  PFNGLCREATETEXTURESPROC CreateTextures = nullptr;
  PFNGLCREATEVERTEXARRAYSPROC CreateVertexArrays = nullptr;
  PFNGLDELETEBUFFERSPROC DeleteBuffers = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers = nullptr;
  PFNGLDELETEPROGRAMPROC DeleteProgram = nullptr;
  PFNGLDELETERENDERBUFFERSPROC DeleteRenderbuffers = nullptr;
  PFNGLDELETESHADERPROC DeleteShader = nullptr;
  PFNGLDELETESYNCPROC DeleteSync = nullptr;
  PFNGLDELETETEXTURESPROC DeleteTextures = nullptr;
  PFNGLDELETEVERTEXARRAYSPROC DeleteVertexArrays = nullptr;
  PFNGLDEPTHFUNCPROC DepthFunc = nullptr;
  PFNGLDEPTHMASKPROC DepthMask = nullptr;
  PFNGLDISABLEPROC Disable = nullptr;
  PFNGLDRAWARRAYSPROC DrawArrays = nullptr;
  PFNGLDRAWELEMENTSPROC DrawElements = nullptr;
  PFNGLDRAWELEMENTSINSTANCEDPROC DrawElementsInstanced = nullptr;
  PFNGLENABLEPROC Enable = nullptr;
  PFNGLENABLEVERTEXARRAYATTRIBPROC EnableVertexArrayAttrib = nullptr;
  PFNGLFENCESYNCPROC FenceSync = nullptr;
  PFNGLFINISHPROC Finish = nullptr;
  PFNGLFLUSHPROC Flush = nullptr;
  PFNGLGETERRORPROC GetError = nullptr;
  PFNGLGETINTEGERVPROC GetIntegerv = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC GetProgramInfoLog = nullptr;
  PFNGLGETPROGRAMIVPROC GetProgramiv = nullptr;
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog = nullptr;
  PFNGLGETSHADERIVPROC GetShaderiv = nullptr;
  PFNGLGETSTRINGPROC GetString = nullptr;
  PFNGLLINKPROGRAMPROC LinkProgram = nullptr;
  PFNGLNAMEDBUFFERDATAPROC NamedBufferData = nullptr;
  PFNGLNAMEDBUFFERSUBDATAPROC NamedBufferSubData = nullptr;
  PFNGLNAMEDFRAMEBUFFERRENDERBUFFERPROC NamedFramebufferRenderbuffer = nullptr;
  PFNGLNAMEDFRAMEBUFFERTEXTUREPROC NamedFramebufferTexture = nullptr;
  PFNGLNAMEDRENDERBUFFERSTORAGEMULTISAMPLEPROC NamedRenderbufferStorageMultisample = nullptr;
  PFNGLPIXELSTOREIPROC PixelStorei = nullptr;
  PFNGLREADPIXELSPROC ReadPixels = nullptr;
  PFNGLSHADERSOURCEPROC ShaderSource = nullptr;
  PFNGLTEXTUREPARAMETERIPROC TextureParameteri = nullptr;
  PFNGLTEXTURESTORAGE2DPROC TextureStorage2D = nullptr;
  PFNGLTEXTURESTORAGE3DPROC TextureStorage3D = nullptr;
  PFNGLTEXTURESUBIMAGE3DPROC TextureSubImage3D = nullptr;
  PFNGLGENERATETEXTUREMIPMAPPROC GenerateTextureMipmap = nullptr;
  PFNGLUNIFORM1FPROC Uniform1f = nullptr;
  PFNGLUNIFORM1IPROC Uniform1i = nullptr;
  PFNGLUNIFORM3FPROC Uniform3f = nullptr;
  PFNGLGETUNIFORMLOCATIONPROC GetUniformLocation = nullptr;
  PFNGLUNIFORMMATRIX4FVPROC UniformMatrix4fv = nullptr;
  PFNGLUSEPROGRAMPROC UseProgram = nullptr;
  PFNGLVERTEXARRAYATTRIBBINDINGPROC VertexArrayAttribBinding = nullptr;
  PFNGLVERTEXARRAYATTRIBFORMATPROC VertexArrayAttribFormat = nullptr;
  PFNGLVERTEXARRAYELEMENTBUFFERPROC VertexArrayElementBuffer = nullptr;
  PFNGLVERTEXARRAYVERTEXBUFFERPROC VertexArrayVertexBuffer = nullptr;
  PFNGLVIEWPORTPROC Viewport = nullptr;

  /// Loads every function. Returns the first name that the context lacks, or "".
  std::string load(const LoadFunction& find);
};

}  // namespace pelage
