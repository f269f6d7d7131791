package org.robotui.gl.internal.draw;

import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.splat.Brush;
import org.robotui.gl.internal.splat.PointPainter;
import org.robotui.gl.internal.splat.Splats;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.Shape;

/** Points where OpenGL is software: written by ourselves, and sent nowhere. Only translucent ones go to OpenGL. */
final class SplattedPoints implements Drawn {
  private final Gpu gpu;
  private PointSet points = PointSet.of(FloatBuffer.allocate(0), Optional.empty(), 1, Unit.PIXELS);
  private boolean translucent;
  private Optional<DrawnPoints> inOpenGl = Optional.empty();

  SplattedPoints(Gpu gpu) {
    this.gpu = gpu;
  }

  @Override
  public boolean takes(Shape shape) {
    return shape instanceof PointSet;
  }

  @Override
  public long fill(Shape shape) {
    points = (PointSet) shape;
    translucent = Opacity.translucent(points.rgba());
    delete();
    return 0;
  }

  @Override
  public boolean translucent() {
    return translucent;
  }

  @Override
  public boolean paint(Pass pass, DrawState look) {
    Optional<Splats> splats = pass.splats();
    boolean painted = splats.isPresent() && (pass.picking() || !translucent && look.color().alpha() == 1);
    if (painted) {
      PointSet.Part part = points.part(pass.every());
      int count = new PointPainter(splats.get(), brush(pass, look)).paint(part.points(), part.every(), pass.givenUp());
      pass.tally().points(count, points.elements() - count);
    }
    return painted;
  }

  @Override
  public void draw(Pass pass, DrawState look) {
    inOpenGl().draw(pass, look);
  }

  private DrawnPoints inOpenGl() {
    if (inOpenGl.isEmpty()) {
      inOpenGl = Optional.of(new DrawnPoints(gpu));
      inOpenGl.get().fill(points);
    }
    return inOpenGl.get();
  }

  private Brush brush(Pass pass, DrawState look) {
    boolean metres = points.unit() == Unit.METRES;
    int pixels = metres ? 0 : Math.max(1, Math.round(points.size() * pass.camera().scale()));
    float reach = (float) (points.size() * pass.camera().reach());
    return new Brush(look.clipFromShape().floats(), pixels, reach, points.style(), look.color(), pass.glow(look),
        (float) look.near(), (float) look.far(),
        look.id());
  }

  @Override
  public long bytes() {
    return inOpenGl.map(DrawnPoints::bytes).orElse(0L);
  }

  @Override
  public void delete() {
    inOpenGl.ifPresent(DrawnPoints::delete);
    inOpenGl = Optional.empty();
  }
}
