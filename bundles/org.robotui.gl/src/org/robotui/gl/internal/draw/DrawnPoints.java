package org.robotui.gl.internal.draw;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.gl.internal.draw.Shader.Trait;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.Program;
import org.robotui.gl.internal.gpu.VertexArray;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.PointSet.Style;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.Shape;

/** Points. Thinned by longer strides through the same buffers. */
final class DrawnPoints implements Drawn {
  private static final int ROW = 12;
  private static final int PIECE = 50_000;
  private static final Shader SHADER = Shader.of("points");

  private final VertexArray array;
  private final Corners corners;
  private PointSet points = PointSet.of(FloatBuffer.allocate(0), Optional.empty(), 1, Unit.PIXELS);
  private int laidEvery;

  DrawnPoints(Gpu gpu) {
    array = new VertexArray(gpu);
    corners = new Corners(gpu);
  }

  @Override
  public boolean takes(Shape shape) {
    return shape instanceof PointSet;
  }

  @Override
  public long fill(Shape shape) {
    points = (PointSet) shape;
    laidEvery = 0;
    return corners.fill(points.xyz(), points.rgba());
  }

  @Override
  public boolean translucent() {
    return corners.translucent();
  }

  @Override
  public void draw(Pass pass, DrawState look) {
    int every = Math.min(pass.every(), pass.gpu().limits().stride() / ROW);
    array.bind();
    lay(every);
    GL3 gl = pass.gl();
    Program program = pass.use(
        SHADER.with(Trait.METRES, points.unit() == Unit.METRES).with(Trait.DISC, points.style() == Style.DISC), look);
    size(pass, program);
    sprites(gl, points.style() == Style.DISC);
    int count = (points.elements() + every - 1) / every;
    draw(pass, count);
    sprites(gl, false);
    gl.glDisable(GL3.GL_PROGRAM_POINT_SIZE);
    pass.tally().points(count, points.elements() - count);
  }

  /** All at once; by pieces where software takes a third of a second for a million. */
  private static void draw(Pass pass, int count) {
    int most = pass.gpu().limits().software() ? PIECE : Math.max(1, count);
    for (int first = 0; first < count && !pass.givenUp().getAsBoolean(); first += most) {
      pass.gl().glDrawArrays(GL.GL_POINTS, first, Math.min(most, count - first));
      if (most < count) {
        pass.gl().glFinish();
      }
    }
  }

  /** Only what is round needs to know where in the point a pixel is; without that, software is twice as fast. */
  private static void sprites(GL3 gl, boolean wanted) {
    if (gl.isGL2() && wanted) {
      gl.glEnable(GL2.GL_POINT_SPRITE);
    } else if (gl.isGL2()) {
      gl.glDisable(GL2.GL_POINT_SPRITE);
    }
  }

  private void lay(int every) {
    if (laidEvery != every) {
      corners.lay(array, every);
      laidEvery = every;
    }
    corners.whiten(array);
  }

  private void size(Pass pass, Program program) {
    if (points.unit() == Unit.METRES) {
      pass.gl().glEnable(GL3.GL_PROGRAM_POINT_SIZE);
      program.number("reach", (float) (points.size() * pass.camera().reach()));
    } else {
      pass.gl().glPointSize(Math.max(1, points.size() * pass.camera().scale()));
    }
  }

  @Override
  public long bytes() {
    return corners.bytes();
  }

  @Override
  public void delete() {
    array.delete();
    corners.delete();
  }
}
