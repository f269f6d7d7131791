package org.robotui.gl.internal.draw;

import com.jogamp.opengl.GL;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.robotui.gl.internal.draw.Shader.Trait;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.GpuBuffer;
import org.robotui.gl.internal.gpu.VertexArray;
import org.robotui.gl.shape.TriangleMesh;

/** The buffers of a mesh, laid into a vertex array to which more may be added. */
final class Surface {
  private static final int CORNERS = 3;
  /** Fewer triangles are drawn as they are. */
  private static final int MANY = 1000;
  /** Pictures. */
  private static final int SETTLED = 3;
  private static final int NORMAL = 2;
  private static final int UV = 3;
  private static final Shader SHADER = Shader.of("mesh");

  private final Gpu gpu;
  private final VertexArray array;
  private final Corners corners;
  private final GpuBuffer indices;
  private Optional<GpuBuffer> normals = Optional.empty();
  private Optional<GpuBuffer> uv = Optional.empty();
  private Optional<Settled> settled = Optional.empty();
  private int pictures;
  private TriangleMesh mesh = TriangleMesh.of(FloatBuffer.allocate(0), Optional.empty(), IntBuffer.allocate(0));

  Surface(Gpu gpu) {
    this.gpu = gpu;
    array = new VertexArray(gpu);
    corners = new Corners(gpu);
    indices = GpuBuffer.ofIndices(gpu);
  }

  /** Takes a mesh, unless it has it; answers the bytes sent. */
  long fill(TriangleMesh wanted) {
    if (wanted == mesh) {
      return 0;
    }
    mesh = wanted;
    unsettle();
    pictures = 0;
    array.bind();
    long sent = corners.fill(mesh.xyz(), mesh.rgba()) + indices.fill(mesh.triangles());
    corners.lay(array, 1);
    normals = buffer(normals, mesh.normals());
    uv = buffer(uv, mesh.uv());
    sent += lay(NORMAL, 3, normals, mesh.normals()) + lay(UV, 2, uv, mesh.uv());
    indices.bind();
    return sent;
  }

  private Optional<GpuBuffer> buffer(Optional<GpuBuffer> present, Optional<FloatBuffer> numbers) {
    return numbers.isPresent() && present.isEmpty() ? Optional.of(GpuBuffer.ofVertices(gpu)) : present;
  }

  private long lay(int slot, int each, Optional<GpuBuffer> buffer, Optional<FloatBuffer> numbers) {
    if (numbers.isEmpty()) {
      array.none(slot);
      return 0;
    }
    long sent = buffer.orElseThrow().fill(numbers.get());
    array.floats(slot, buffer.orElseThrow(), each, 1);
    return sent;
  }

  /** Which shaders draw it. */
  Shader shader(DrawState look) {
    return SHADER
        .with(Trait.LIT, look.lit())
        .with(Trait.FACETS, look.lit() && mesh.normals().isEmpty())
        .with(Trait.TEXTURED, isTextured(look));
  }

  private boolean isTextured(DrawState look) {
    return look.texture().isPresent() && mesh.uv().isPresent();
  }

  VertexArray array() {
    return array;
  }

  /** Makes it the one that is drawn. */
  void bind(DrawState look) {
    array.bind();
    corners.whiten(array);
    look.texture().ifPresent(texture -> texture.bind());
  }

  /** Writes it into the splats of a picture, where the processor is quicker with it; answers whether it did. */
  boolean paint(Pass pass, DrawState look) {
    boolean plain = !pass.picking() && !pass.fineness().isExact() && !translucent() && look.color().alpha() == 1
        && !isTextured(look);
    return plain && pass.splats().flatMap(splats -> settled.map(form -> form.paint(pass, look, splats))).orElse(false);
  }

  /** As fine as is seen. */
  void draw(Pass pass, DrawState look) {
    if (!pass.fineness().isExact()) {
      settle();
    }
    settled.filter(form -> mayBeCoarser(pass)).ifPresentOrElse(form -> draw(pass, look, form), () -> drawAll(pass));
  }

  private boolean mayBeCoarser(Pass pass) {
    return !pass.fineness().isExact() && mesh.elements() >= MANY;
  }

  /**
   * Not before it has stayed the same for some pictures: what is found out of a mesh that changes with each would cost
   * more than it saves.
   */
  private void settle() {
    if (settled.isEmpty() && ++pictures >= SETTLED) {
      Settled form = new Settled(mesh);
      indices.fill(form.indices());
      settled = Optional.of(form);
    }
  }

  private void drawAll(Pass pass) {
    draw(pass, 0, mesh.triangles().remaining(), 0);
  }

  private void draw(Pass pass, DrawState look, Settled form) {
    Levels.Level now = form.now(pass, look);
    boolean body = form.hidesBacks(pass) && !translucent() && look.color().alpha() == 1;
    if (body) {
      pass.gl().glEnable(GL.GL_CULL_FACE);
    }
    draw(pass, now.first(), now.count(), form.leftOut(pass, look, now));
    if (body) {
      pass.gl().glDisable(GL.GL_CULL_FACE);
    }
  }

  private void draw(Pass pass, int first, int count, int leftOut) {
    pass.gl().glDrawElements(GL.GL_TRIANGLES, count, GL.GL_UNSIGNED_INT, (long) Integer.BYTES * first);
    pass.tally().triangles(count / CORNERS, leftOut);
  }

  void draw(Pass pass, int instances) {
    pass.gl().glDrawElementsInstanced(GL.GL_TRIANGLES, mesh.triangles().remaining(), GL.GL_UNSIGNED_INT, 0, instances);
    pass.tally().triangles((long) mesh.elements() * instances, 0);
  }

  boolean translucent() {
    return corners.translucent();
  }

  long bytes() {
    return corners.bytes() + indices.bytes() + normals.map(GpuBuffer::bytes).orElse(0L)
        + uv.map(GpuBuffer::bytes).orElse(0L);
  }

  private void unsettle() {
    settled.ifPresent(Settled::close);
    settled = Optional.empty();
  }

  void delete() {
    unsettle();
    array.delete();
    corners.delete();
    indices.delete();
    normals.ifPresent(GpuBuffer::delete);
    uv.ifPresent(GpuBuffer::delete);
  }
}
