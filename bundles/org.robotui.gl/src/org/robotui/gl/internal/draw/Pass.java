package org.robotui.gl.internal.draw;

import com.jogamp.opengl.GL3;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.function.BooleanSupplier;
import org.robotui.geometry.Vector3;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.Program;
import org.robotui.gl.internal.splat.Splats;
import org.robotui.gl.internal.text.GlyphTexture;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Rgba;

/** The drawing of one picture, or of the few pixels around the pointer. */
public final class Pass {
  /** Selected things glow in the colour of what is chosen. */
  private static final Rgba GLOW = new Rgba(1, 0.72f, 0.2f, 0.5f);

  private final Gpu gpu;
  private final Camera camera;
  private final Programs programs;
  private final GlyphTexture glyphs;
  private final ExecutorService workers;
  private final Rgba background;
  private final Optional<Splats> splats;
  private final boolean picking;
  private final int every;
  private final Fineness fineness;
  private final BooleanSupplier givenUp;
  private final Tally tally = new Tally();

  /**
   * Begins.
   *
   * @param gpu where
   * @param camera from where
   * @param tools shaders and glyphs
   * @param background behind everything
   * @param splats where points are written that OpenGL does not draw; none where it draws all
   * @param picking whether parts and elements are drawn in place of colours
   * @param every n-th point is drawn
   * @param fineness of surfaces
   * @param givenUp whether the rest need not be drawn
   */
  public Pass(Gpu gpu, Camera camera, Tools tools, Rgba background, Optional<Splats> splats, boolean picking, int every,
      Fineness fineness,
      BooleanSupplier givenUp) {
    this.gpu = gpu;
    this.camera = camera;
    this.programs = tools.programs();
    this.glyphs = tools.glyphs();
    this.workers = tools.background();
    this.background = background;
    this.splats = splats;
    this.picking = picking;
    this.every = every;
    this.fineness = fineness;
    this.givenUp = givenUp;
  }

  GL3 gl() {
    return gpu.gl();
  }

  Gpu gpu() {
    return gpu;
  }

  Camera camera() {
    return camera;
  }

  GlyphTexture glyphs() {
    return glyphs;
  }

  /** Where is done what takes long. */
  ExecutorService workers() {
    return workers;
  }

  Rgba background() {
    return background;
  }

  Optional<Splats> splats() {
    return splats;
  }

  /** What is mixed into colours, as much as its alpha says. */
  Rgba glow(DrawState look) {
    return look.selected() ? GLOW : background.withAlpha(look.pale());
  }

  int every() {
    return every;
  }

  Fineness fineness() {
    return fineness;
  }

  /** What a pixel shows of the nearest end of a shape; metres. */
  double metresPerPixel(DrawState look, Optional<Box3> bounds) {
    double distance = camera.perspective()
        ? bounds.map(box -> look.eyeFromShape().apply(box.center())[0] - box.radius()).orElse(0.0)
        : 1;
    return Math.max(0, distance) / camera.reach();
  }

  /** What is up, seen from the eye: x ahead, y to the left, z up. */
  float[] up() {
    Vector3 up = camera.eyeFromFixed().rotation().rotate(new Vector3(0, 0, 1));
    return new float[]{(float) up.x(), (float) up.y(), (float) up.z()};
  }

  /** Asked between pieces of what takes long. */
  BooleanSupplier givenUp() {
    return givenUp;
  }

  /**
   * Whether parts and elements are drawn in place of colours.
   *
   * @return true where something is searched
   */
  public boolean picking() {
    return picking;
  }

  /**
   * What was drawn.
   *
   * @return the count
   */
  public Tally tally() {
    return tally;
  }

  /** Makes shaders the ones that are drawn with, with what all of them know of a part. */
  Program use(Shader shader, DrawState look) {
    Program program = programs.get(picking ? shader.with(Shader.Trait.PICK) : shader);
    program.use();
    program.matrix("clipFromShape", look.clipFromShape().floats());
    program.color("tint", look.color());
    program.color("glow", glow(look));
    program.whole("part", look.id());
    return program;
  }

  /** What shaders of surfaces in light know besides. */
  void light(Program program, DrawState look) {
    program.matrix("eyeFromShape", look.eyeFromShape().floats());
    float[] up = up();
    program.triple("up", up[0], up[1], up[2]);
    program.number("perspective", camera.perspective() ? 1 : 0);
  }
}
