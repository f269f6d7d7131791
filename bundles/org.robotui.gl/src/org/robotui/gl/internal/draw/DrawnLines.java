package org.robotui.gl.internal.draw;

import com.jogamp.opengl.GL;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.VertexArray;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.LineSet.Kind;
import org.robotui.gl.shape.Shape;

/** Lines, as wide as OpenGL draws them. */
final class DrawnLines implements Drawn {
  private static final Shader SHADER = Shader.of("lines");

  private final VertexArray array;
  private final Corners corners;
  private LineSet lines = LineSet.of(Kind.STRIP, 1);

  DrawnLines(Gpu gpu) {
    array = new VertexArray(gpu);
    corners = new Corners(gpu);
  }

  @Override
  public boolean takes(Shape shape) {
    return shape instanceof LineSet;
  }

  @Override
  public long fill(Shape shape) {
    lines = (LineSet) shape;
    long sent = corners.fill(lines.xyz(), lines.rgba());
    array.bind();
    corners.lay(array, 1);
    return sent;
  }

  @Override
  public boolean translucent() {
    return corners.translucent();
  }

  @Override
  public void draw(Pass pass, DrawState look) {
    array.bind();
    corners.whiten(array);
    pass.use(SHADER, look);
    pass.gl().glLineWidth(Math.clamp(lines.width() * pass.camera().scale(), 1, pass.gpu().limits().lineWidth()));
    pass.gl().glDrawArrays(lines.kind() == Kind.STRIP ? GL.GL_LINE_STRIP : GL.GL_LINES, 0, lines.xyz().remaining() / 3);
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
