package org.robotui.gl.internal.draw;

import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.shape.Shape;
import org.robotui.gl.shape.TriangleMesh;

/** A surface. */
final class DrawnMesh implements Drawn {
  private final Surface surface;

  DrawnMesh(Gpu gpu) {
    surface = new Surface(gpu);
  }

  @Override
  public boolean takes(Shape shape) {
    return shape instanceof TriangleMesh;
  }

  @Override
  public long fill(Shape shape) {
    return surface.fill((TriangleMesh) shape);
  }

  @Override
  public boolean translucent() {
    return surface.translucent();
  }

  @Override
  public boolean paint(Pass pass, DrawState look) {
    return surface.paint(pass, look);
  }

  @Override
  public void draw(Pass pass, DrawState look) {
    surface.bind(look);
    pass.light(pass.use(surface.shader(look), look), look);
    surface.draw(pass, look);
  }

  @Override
  public long bytes() {
    return surface.bytes();
  }

  @Override
  public void delete() {
    surface.delete();
  }
}
