package org.robotui.gl.internal.draw;

import java.util.Optional;
import org.robotui.gl.internal.draw.Shader.Trait;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.GpuBuffer;
import org.robotui.gl.internal.gpu.VertexArray;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Shape;

/** One mesh many times, drawn in one go. */
final class DrawnInstances implements Drawn {
  private static final int AT = 4;
  private static final int TURN = 5;
  private static final int SCALE = 6;
  private static final int OWN_COLOR = 7;
  private static final int FLOAT = 4;
  private static final int ROW = Instances.PLACING * FLOAT;

  private final Gpu gpu;
  private final Surface surface;
  private final GpuBuffer placings;
  private Optional<GpuBuffer> colors = Optional.empty();
  private boolean colored;
  private boolean translucent;
  private int count;

  DrawnInstances(Gpu gpu) {
    this.gpu = gpu;
    surface = new Surface(gpu);
    placings = GpuBuffer.ofVertices(gpu);
  }

  @Override
  public boolean takes(Shape shape) {
    return shape instanceof Instances;
  }

  @Override
  public long fill(Shape shape) {
    Instances instances = (Instances) shape;
    count = instances.elements();
    long sent = surface.fill(instances.mesh()) + placings.fill(instances.placings());
    VertexArray array = surface.array();
    array.bind();
    array.floats(AT, placings, 3, ROW, 0);
    array.floats(TURN, placings, 4, ROW, 3 * FLOAT);
    array.floats(SCALE, placings, 3, ROW, 7 * FLOAT);
    sent += fillColors(instances, array);
    array.perInstance(AT, TURN, SCALE, OWN_COLOR);
    return sent;
  }

  private long fillColors(Instances instances, VertexArray array) {
    colored = instances.rgba().isPresent();
    translucent = Opacity.translucent(instances.rgba());
    if (!colored) {
      array.none(OWN_COLOR);
      return 0;
    }
    GpuBuffer buffer = colors.orElseGet(() -> GpuBuffer.ofVertices(gpu));
    colors = Optional.of(buffer);
    long sent = buffer.fill(instances.rgba().get());
    array.colors(OWN_COLOR, buffer, 1);
    return sent;
  }

  @Override
  public boolean translucent() {
    return translucent || surface.translucent();
  }

  @Override
  public void draw(Pass pass, DrawState look) {
    surface.bind(look);
    if (!colored) {
      surface.array().white(OWN_COLOR);
    }
    pass.light(pass.use(surface.shader(look).with(Trait.INSTANCED), look), look);
    surface.draw(pass, count);
  }

  @Override
  public long bytes() {
    return surface.bytes() + placings.bytes() + colors.map(GpuBuffer::bytes).orElse(0L);
  }

  @Override
  public void delete() {
    surface.delete();
    placings.delete();
    colors.ifPresent(GpuBuffer::delete);
  }
}
