package org.robotui.gl.internal.scene;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.gl.internal.draw.Camera;
import org.robotui.gl.internal.draw.DrawState;
import org.robotui.gl.internal.draw.Matrix;
import org.robotui.gl.internal.draw.Pass;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.render.RenderRequest.Selected;
import org.robotui.gl.shape.Rgba;

/** Draws what is seen into the target that is bound. */
final class Canvas {
  /** What lies on top has the front of the depths to itself. */
  static final double TOP = 0.1;

  private final GL3 gl;
  private final Pass pass;
  private final Camera camera;
  private final List<Selected> selection;
  private final Map<Integer, Resident> byId = new HashMap<>();
  private final Set<Resident> painted = Collections.newSetFromMap(new IdentityHashMap<>());

  Canvas(Gpu gpu, Pass pass, Camera camera, List<Selected> selection) {
    this.gl = gpu.gl();
    this.pass = pass;
    this.camera = camera;
    this.selection = selection;
    gl.glEnable(GL.GL_DEPTH_TEST);
    gl.glDepthFunc(GL.GL_LEQUAL);
    gl.glDisable(GL.GL_CULL_FACE);
    gl.glFrontFace(GL.GL_CW); // rows of a picture go down, and so what is counterclockwise to the eye is not to OpenGL
    gl.glDisable(GL.GL_DITHER);
  }

  /** Fills the target with one colour. Alpha stays 0, so that pixels are plain numbers of red, green and blue. */
  void clear(Rgba background) {
    gl.glDisable(GL.GL_BLEND);
    gl.glDepthMask(true);
    gl.glColorMask(true, true, true, true);
    gl.glClearColor(background.red(), background.green(), background.blue(), 0);
    gl.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT);
    keepAlpha();
  }

  /** What is drawn leaves alpha as it is. */
  void keepAlpha() {
    gl.glDepthMask(true);
    gl.glColorMask(true, true, true, false);
  }

  /** Writes what the processor paints beside OpenGL into splats. */
  void paint(Order order) {
    for (Resident resident : order.opaque()) {
      DrawState look = resident.onTop() ? look(resident, 0, TOP) : look(resident, TOP, 1);
      if (resident.drawn().paint(pass, look)) {
        painted.add(resident);
      }
    }
  }

  /** Whether the processor has painted all that is seen, so that the picture needs nothing of OpenGL. */
  boolean hasPainted(Order order) {
    return order.translucent().isEmpty() && painted.containsAll(order.opaque());
  }

  /** Draws colours: translucent things over the opaque ones, without hiding each other. */
  void draw(Order order) {
    gl.glDisable(GL.GL_BLEND);
    drawBoth(order.opaque().stream().filter(resident -> !painted.contains(resident)).toList());
    gl.glEnable(GL.GL_BLEND);
    gl.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA);
    gl.glDepthMask(false);
    drawBoth(order.translucent());
    gl.glDepthMask(true);
    gl.glDisable(GL.GL_BLEND);
  }

  /** Draws which part and element is where. */
  void drawIds(Order order) {
    gl.glDisable(GL.GL_BLEND);
    gl.glDepthMask(true);
    drawBoth(order.opaque());
    drawBoth(order.translucent());
  }

  private void drawBoth(List<Resident> residents) {
    gl.glDepthRange(TOP, 1);
    residents.stream().filter(resident -> !resident.onTop()).forEach(resident -> draw(resident, TOP, 1));
    gl.glDepthRange(0, TOP);
    residents.stream().filter(Resident::onTop).forEach(resident -> draw(resident, 0, TOP));
  }

  private void draw(Resident resident, double near, double far) {
    DrawState look = look(resident, near, far);
    if (!pass.picking() || !resident.drawn().paint(pass, look)) {
      resident.drawn().draw(pass, look);
    }
  }

  private DrawState look(Resident resident, double near, double far) {
    int id = byId.size() + 1;
    byId.put(id, resident);
    Matrix eyeFromShape = Matrix.of(camera.eyeFromFixed().times(resident.part().fixedFromShape()));
    boolean selected = selection.contains(new Selected(resident.display(), resident.part().key()));
    return new DrawState(
        eyeFromShape, camera.clipFromEye().times(eyeFromShape), resident.part().material().color(),
        resident.part().material().lit(),
        resident.picture().map(Pool.Picture::texture), selected, resident.part().material().pale(), near, far, id);
  }

  /** The part that was drawn with an id. */
  Optional<Resident> drawnAs(int id) {
    return Optional.ofNullable(byId.get(id));
  }
}
