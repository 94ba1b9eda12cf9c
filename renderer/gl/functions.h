// The OpenGL 4.5 functions that Pelage uses, loaded through the context (never linked: see docs/headless-gl.md).
#pragma once

#include <GL/glcorearb.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace pelage {

/// Looks up a function by name; returns null if the context lacks it.
using LoadFunction = std::function<void*(const char*)>;

/// Counts of GL calls. `bytes`: sent from the CPU to buffers and textures. `allocated`: bytes of storage that was
/// allocated, without a texture's smaller mip levels, which add a third or less. `objects`: objects that were created.
struct GlCounts {
  std::size_t programs = 0, draws = 0, textures = 0, bytes = 0, allocated = 0, objects = 0;
};

/// A table of functions, valid for one context on one thread. Calls that appear in GlCounts are counted.
struct Gl {
  PFNGLATTACHSHADERPROC AttachShader = nullptr;
  PFNGLBEGINQUERYPROC BeginQuery = nullptr;
  PFNGLBINDBUFFERBASEPROC BindBufferBase = nullptr;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer = nullptr;
  PFNGLBINDVERTEXARRAYPROC BindVertexArray = nullptr;
  PFNGLBLENDEQUATIONPROC BlendEquation = nullptr;
  PFNGLBLENDFUNCPROC BlendFunc = nullptr;
  PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC CheckNamedFramebufferStatus = nullptr;
  PFNGLCLEARNAMEDBUFFERDATAPROC ClearNamedBufferData = nullptr;
  PFNGLCLEARNAMEDFRAMEBUFFERFVPROC ClearNamedFramebufferfv = nullptr;
  PFNGLCLIENTWAITSYNCPROC ClientWaitSync = nullptr;
  PFNGLCLIPCONTROLPROC ClipControl = nullptr;
  PFNGLCOLORMASKPROC ColorMask = nullptr;
  PFNGLCOMPILESHADERPROC CompileShader = nullptr;
  PFNGLCOPYTEXTURESUBIMAGE3DPROC CopyTextureSubImage3D = nullptr;
  PFNGLCREATEBUFFERSPROC CreateBuffers = nullptr;
  PFNGLCREATEFRAMEBUFFERSPROC CreateFramebuffers = nullptr;
  PFNGLCREATEPROGRAMPROC CreateProgram = nullptr;
  PFNGLCREATEQUERIESPROC CreateQueries = nullptr;
  PFNGLCREATERENDERBUFFERSPROC CreateRenderbuffers = nullptr;
  PFNGLCREATESHADERPROC CreateShader = nullptr;
  PFNGLCREATETEXTURESPROC CreateTextures = nullptr;
  PFNGLCREATEVERTEXARRAYSPROC CreateVertexArrays = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers = nullptr;
  PFNGLDELETEPROGRAMPROC DeleteProgram = nullptr;
  PFNGLDELETEQUERIESPROC DeleteQueries = nullptr;
  PFNGLDELETESHADERPROC DeleteShader = nullptr;
  PFNGLDELETESYNCPROC DeleteSync = nullptr;
  PFNGLDELETEVERTEXARRAYSPROC DeleteVertexArrays = nullptr;
  PFNGLDEPTHFUNCPROC DepthFunc = nullptr;
  PFNGLDEPTHMASKPROC DepthMask = nullptr;
  PFNGLDISABLEPROC Disable = nullptr;
  PFNGLDISPATCHCOMPUTEPROC DispatchCompute = nullptr;
  PFNGLENABLEPROC Enable = nullptr;
  PFNGLENDQUERYPROC EndQuery = nullptr;
  PFNGLENABLEVERTEXARRAYATTRIBPROC EnableVertexArrayAttrib = nullptr;
  PFNGLFENCESYNCPROC FenceSync = nullptr;
  PFNGLFINISHPROC Finish = nullptr;
  PFNGLFLUSHPROC Flush = nullptr;
  PFNGLGETERRORPROC GetError = nullptr;
  PFNGLGETGRAPHICSRESETSTATUSPROC GetGraphicsResetStatus = nullptr;
  PFNGLGETINTEGER64VPROC GetInteger64v = nullptr;
  PFNGLGETINTEGERVPROC GetIntegerv = nullptr;
  PFNGLGETNAMEDBUFFERSUBDATAPROC GetNamedBufferSubData = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC GetProgramInfoLog = nullptr;
  PFNGLGETPROGRAMIVPROC GetProgramiv = nullptr;
  PFNGLGETQUERYOBJECTUI64VPROC GetQueryObjectui64v = nullptr;
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog = nullptr;
  PFNGLGETSHADERIVPROC GetShaderiv = nullptr;
  PFNGLGETSTRINGPROC GetString = nullptr;
  PFNGLLINKPROGRAMPROC LinkProgram = nullptr;
  PFNGLMEMORYBARRIERPROC MemoryBarrier = nullptr;
  PFNGLNAMEDFRAMEBUFFERRENDERBUFFERPROC NamedFramebufferRenderbuffer = nullptr;
  PFNGLNAMEDFRAMEBUFFERTEXTUREPROC NamedFramebufferTexture = nullptr;
  PFNGLPIXELSTOREIPROC PixelStorei = nullptr;
  PFNGLREADPIXELSPROC ReadPixels = nullptr;
  PFNGLSCISSORPROC Scissor = nullptr;
  PFNGLSHADERSOURCEPROC ShaderSource = nullptr;
  PFNGLTEXTUREPARAMETERIPROC TextureParameteri = nullptr;
  PFNGLGENERATETEXTUREMIPMAPPROC GenerateTextureMipmap = nullptr;
  PFNGLUNIFORM1FPROC Uniform1f = nullptr;
  PFNGLUNIFORM1IPROC Uniform1i = nullptr;
  PFNGLUNIFORM1UIPROC Uniform1ui = nullptr;
  PFNGLUNIFORM2IPROC Uniform2i = nullptr;
  PFNGLUNIFORM3FPROC Uniform3f = nullptr;
  PFNGLGETUNIFORMLOCATIONPROC GetUniformLocation = nullptr;
  PFNGLUNIFORMMATRIX4FVPROC UniformMatrix4fv = nullptr;
  PFNGLVERTEXARRAYATTRIBBINDINGPROC VertexArrayAttribBinding = nullptr;
  PFNGLVERTEXARRAYATTRIBFORMATPROC VertexArrayAttribFormat = nullptr;
  PFNGLVERTEXARRAYELEMENTBUFFERPROC VertexArrayElementBuffer = nullptr;
  PFNGLVERTEXARRAYVERTEXBUFFERPROC VertexArrayVertexBuffer = nullptr;
  PFNGLVIEWPORTPROC Viewport = nullptr;

  void BindTextureUnit(GLuint unit, GLuint texture) const;
  void DeleteBuffers(GLsizei count, const GLuint* buffers) const;
  void DeleteRenderbuffers(GLsizei count, const GLuint* buffers) const;
  void DeleteTextures(GLsizei count, const GLuint* textures) const;
  void DrawArrays(GLenum mode, GLint first, GLsizei count) const;
  void DrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) const;
  void DrawElementsInstanced(GLenum mode, GLsizei count, GLenum type, const void* indices, GLsizei instances) const;
  void NamedBufferData(GLuint buffer, GLsizeiptr size, const void* data, GLenum usage) const;
  void NamedRenderbufferStorage(GLuint buffer, GLenum format, GLsizei width, GLsizei height) const;
  void NamedBufferSubData(GLuint buffer, GLintptr offset, GLsizeiptr size, const void* data) const;
  void TextureStorage2D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height) const;
  void TextureStorage3D(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height,
                        GLsizei depth) const;
  /// `format` is GL_RED, GL_RG or GL_RGBA, and `type` bytes or floats.
  void TextureSubImage2D(GLuint texture, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                         GLenum type, const void* pixels) const;
  void TextureSubImage3D(GLuint texture, GLint level, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                         GLsizei depth, GLenum format, GLenum type, const void* pixels) const;
  void UseProgram(GLuint program) const;

  /// Counts an object; called by whoever creates one (handles.h).
  void count_object() const { ++counts_.objects; }
  /// Returns the counts since the last call.
  GlCounts take_counts() const { return std::exchange(counts_, {}); }

  /// Return the bytes of storage of all buffers, textures and renderbuffers, and of one of them (0 without storage).
  std::size_t storage_bytes() const { return storage_bytes_; }
  std::size_t bytes_of_buffer(GLuint buffer) const { return bytes_of({Kind::buffer, buffer}); }
  std::size_t bytes_of_texture(GLuint texture) const { return bytes_of({Kind::texture, texture}); }

  /// Returns whether the GL draws on the CPU, as Mesa's software drivers do.
  bool is_software() const;
  /// Loads all functions. Returns the name of the first one that the context lacks, or "".
  std::string load(const LoadFunction& find);

 private:
  /// The functions behind those that count.
  struct Counted {
    PFNGLBINDTEXTUREUNITPROC BindTextureUnit = nullptr;
    PFNGLDELETEBUFFERSPROC DeleteBuffers = nullptr;
    PFNGLDELETERENDERBUFFERSPROC DeleteRenderbuffers = nullptr;
    PFNGLDELETETEXTURESPROC DeleteTextures = nullptr;
    PFNGLDRAWARRAYSPROC DrawArrays = nullptr;
    PFNGLDRAWELEMENTSPROC DrawElements = nullptr;
    PFNGLDRAWELEMENTSINSTANCEDPROC DrawElementsInstanced = nullptr;
    PFNGLNAMEDBUFFERDATAPROC NamedBufferData = nullptr;
    PFNGLNAMEDBUFFERSUBDATAPROC NamedBufferSubData = nullptr;
    PFNGLNAMEDRENDERBUFFERSTORAGEPROC NamedRenderbufferStorage = nullptr;
    PFNGLTEXTURESTORAGE2DPROC TextureStorage2D = nullptr;
    PFNGLTEXTURESTORAGE3DPROC TextureStorage3D = nullptr;
    PFNGLTEXTURESUBIMAGE2DPROC TextureSubImage2D = nullptr;
    PFNGLTEXTURESUBIMAGE3DPROC TextureSubImage3D = nullptr;
    PFNGLUSEPROGRAMPROC UseProgram = nullptr;
  };
  enum class Kind { buffer, texture, renderbuffer };  // names are unique within a kind
  using Name = std::pair<Kind, GLuint>;

  std::size_t bytes_of(Name name) const;
  void note_storage(Name name, std::size_t bytes) const;
  void forget_storage(Kind kind, GLsizei count, const GLuint* names) const;

  Counted counted_;
  // Mutable: counting does not change how the functions behave.
  mutable GlCounts counts_;
  mutable std::map<Name, std::size_t> storage_;  // bytes of storage of each object
  mutable std::size_t storage_bytes_ = 0;
};

}  // namespace pelage
