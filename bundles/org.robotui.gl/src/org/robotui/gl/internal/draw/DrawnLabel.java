package org.robotui.gl.internal.draw;

import com.jogamp.opengl.GL;
import java.nio.FloatBuffer;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.GpuBuffer;
import org.robotui.gl.internal.gpu.Program;
import org.robotui.gl.internal.gpu.VertexArray;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Shape;

/** A line of text that faces the camera, with a rim in the colour of the background. */
final class DrawnLabel implements Drawn {
  private static final int CORNER = 4;
  private static final Shader SHADER = Shader.of("label");

  private final VertexArray array;
  private final GpuBuffer corners;
  private Label label = new Label("", 0, Unit.PIXELS);
  private boolean laid;
  private int count;

  DrawnLabel(Gpu gpu) {
    array = new VertexArray(gpu);
    corners = GpuBuffer.ofVertices(gpu);
  }

  @Override
  public boolean takes(Shape shape) {
    return shape instanceof Label;
  }

  @Override
  public long fill(Shape shape) {
    label = (Label) shape;
    laid = false;
    return label.bytes();
  }

  @Override
  public boolean translucent() {
    return true;
  }

  @Override
  public void draw(Pass pass, DrawState look) {
    array.bind();
    layOut(pass);
    pass.glyphs().bind();
    Camera camera = pass.camera();
    boolean metres = label.unit() == Unit.METRES;
    Program program = pass.use(SHADER.with(Shader.Trait.METRES, metres), look);
    Rgba back = pass.background();
    program.triple("rim", back.red(), back.green(), back.blue());
    program.number("height", metres ? label.height() : label.height() * camera.scale());
    program.pair("pixel", 2f / camera.seenWidth(), 2f / camera.seenHeight());
    program.matrix("clipFromEye", camera.clipFromEye().floats());
    program.matrix("eyeFromShape", look.eyeFromShape().floats());
    pass.gl().glDrawArrays(GL.GL_TRIANGLES, 0, count);
  }

  private void layOut(Pass pass) {
    if (!laid) {
      FloatBuffer laidOut = pass.glyphs().layOut(label.text());
      count = laidOut.remaining() / CORNER;
      corners.fill(laidOut);
      array.floats(0, corners, CORNER, 1);
      laid = true;
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
