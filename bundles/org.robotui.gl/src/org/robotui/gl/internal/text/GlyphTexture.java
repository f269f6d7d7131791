package org.robotui.gl.internal.text;

import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.GpuTexture;

/** The glyphs on the graphics card, from the first label on. */
public final class GlyphTexture {
  private record Sent(Glyphs glyphs, GpuTexture texture) {}

  private final Gpu gpu;
  private Optional<Sent> sent = Optional.empty();

  /**
   * Sends nothing yet.
   *
   * @param gpu where
   */
  public GlyphTexture(Gpu gpu) {
    this.gpu = gpu;
  }

  /**
   * Lays out a line of text.
   *
   * @param text what is written
   * @return corners of triangles: x and y in heights of a line, and the place in the texture
   */
  public FloatBuffer layOut(String text) {
    return TextLayout.layOut(text, present().glyphs);
  }

  /** Makes it the one that is drawn with. */
  public void bind() {
    present().texture.bind();
  }

  private Sent present() {
    Sent present = sent.orElseGet(this::send);
    sent = Optional.of(present);
    return present;
  }

  private Sent send() {
    Glyphs glyphs = new Glyphs();
    return new Sent(glyphs, GpuTexture.ofValues(gpu, glyphs.width(), glyphs.height(), glyphs.distances()));
  }

  /** Frees them. */
  public void delete() {
    sent.map(Sent::texture).ifPresent(GpuTexture::delete);
    sent = Optional.empty();
  }
}
