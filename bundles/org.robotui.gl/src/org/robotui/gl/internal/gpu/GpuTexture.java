package org.robotui.gl.internal.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import org.robotui.gl.internal.gpu.Ledger.Kind;
import org.robotui.gl.shape.Texture;

/** A picture on the graphics card. */
public final class GpuTexture {
  private final Gpu gpu;
  private final int id;
  private final long bytes;
  private final int layout;
  private final int type;

  private GpuTexture(Gpu gpu, long bytes, int layout, int type) {
    this.gpu = gpu;
    this.layout = layout;
    this.type = type;
    this.bytes = bytes;
    int[] ids = new int[1];
    gpu.gl().glGenTextures(1, ids, 0);
    id = gpu.made(Kind.TEXTURE, ids[0]);
    gpu.ledger().grew(bytes);
    bind();
  }

  /**
   * Sends a picture.
   *
   * @param gpu where
   * @param texture the picture
   * @return its copy there
   */
  public static GpuTexture of(Gpu gpu, Texture texture) {
    long base = 4L * texture.width() * texture.height();
    GpuTexture made = new GpuTexture(gpu, texture.smooth() ? base + base / 3 : base, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE);
    made.send(GL.GL_RGBA8, texture.width(), texture.height(), direct(texture.rgba()));
    made.filter(texture.smooth() ? GL.GL_LINEAR_MIPMAP_LINEAR : GL.GL_NEAREST,
        texture.smooth() ? GL.GL_LINEAR : GL.GL_NEAREST);
    if (texture.repeats()) {
      made.wrap(GL.GL_REPEAT);
    }
    if (texture.smooth()) {
      gpu.gl().glGenerateMipmap(GL.GL_TEXTURE_2D);
    }
    gpu.check("sending a texture of " + texture.width() + " x " + texture.height());
    return made;
  }

  /**
   * Sends a picture of one number a pixel.
   *
   * @param gpu where
   * @param width pixels
   * @param height rows
   * @param values one byte each
   * @return its copy there
   */
  public static GpuTexture ofValues(Gpu gpu, int width, int height, ByteBuffer values) {
    GpuTexture made = new GpuTexture(gpu, (long) width * height, GL3.GL_RED, GL.GL_UNSIGNED_BYTE);
    made.send(GL.GL_R8, width, height, direct(values));
    made.filter(GL.GL_LINEAR, GL.GL_LINEAR);
    gpu.check("sending the glyphs");
    return made;
  }

  /**
   * Makes room for pixels that come anew with each picture.
   *
   * @param gpu where
   * @param width pixels
   * @param height rows
   * @param format how they are kept, four bytes each
   * @param layout how they are sent
   * @param type of the numbers sent
   * @return pixels of no colour in particular
   */
  public static GpuTexture ofPixels(Gpu gpu, int width, int height, int format, int layout, int type) {
    GpuTexture made = new GpuTexture(gpu, 4L * width * height, layout, type);
    gpu.gl().glTexImage2D(GL.GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, null);
    made.filter(GL.GL_NEAREST, GL.GL_NEAREST);
    gpu.check("making room for " + width + " x " + height + " pixels");
    return made;
  }

  /**
   * Takes other pixels in place of those of some rows.
   *
   * @param row the first
   * @param width pixels of a row: all of them
   * @param rows how many
   * @param pixels in the layout that it was made for
   */
  void refill(int row, int width, int rows, Buffer pixels) {
    bind();
    gpu.gl().glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 4);
    gpu.gl().glTexSubImage2D(GL.GL_TEXTURE_2D, 0, 0, row, width, rows, layout, type, pixels);
  }

  int id() {
    return id;
  }

  private static ByteBuffer direct(ByteBuffer bytes) {
    return bytes.isDirect() ? bytes : ByteBuffer.allocateDirect(bytes.remaining()).put(bytes.duplicate()).flip();
  }

  private void send(int format, int width, int height, ByteBuffer pixels) {
    gpu.gl().glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1);
    gpu.gl().glTexImage2D(GL.GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, pixels);
  }

  private void filter(int smaller, int larger) {
    gpu.gl().glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, smaller);
    gpu.gl().glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAG_FILTER, larger);
    wrap(GL.GL_CLAMP_TO_EDGE);
  }

  private void wrap(int outside) {
    gpu.gl().glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_WRAP_S, outside);
    gpu.gl().glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_WRAP_T, outside);
  }

  /** Makes it the one that is drawn with. */
  public void bind() {
    gpu.gl().glActiveTexture(GL.GL_TEXTURE0);
    gpu.gl().glBindTexture(GL.GL_TEXTURE_2D, id);
  }

  /**
   * What it takes.
   *
   * @return bytes
   */
  public long bytes() {
    return bytes;
  }

  /** Frees it. */
  public void delete() {
    gpu.gl().glDeleteTextures(1, new int[]{id}, 0);
    gpu.ledger().freed(Kind.TEXTURE);
    gpu.ledger().grew(-bytes);
  }
}
