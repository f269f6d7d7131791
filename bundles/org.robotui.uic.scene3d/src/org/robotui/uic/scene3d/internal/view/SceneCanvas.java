package org.robotui.uic.scene3d.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.shape.Rgba;
import org.robotui.ui.Health;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.uic.scene3d.internal.SceneParts;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.camera.Lens;
import org.robotui.uic.scene3d.internal.model.Selection;
import org.robotui.uic.scene3d.internal.render.PictureRequest;
import org.robotui.uic.scene3d.internal.render.Screen;

/** Paints the newest picture and what lies over it. Display thread. */
final class SceneCanvas {
  private static final int HUNDRED = 100;

  private final SceneParts parts;
  private final SceneSurface surface;
  private final StateView states;
  private final SceneOverlay overlay;
  private final ToolPainter marks;
  private final PicturePane pane;
  private final PaintedCanvas canvas;
  private final Rgba ground;
  private volatile double aspect = 1;

  SceneCanvas(Composite parent, Theme theme, SceneSurface surface, SceneParts parts) {
    this.parts = parts;
    this.surface = surface;
    states = new StateView(theme);
    overlay = new SceneOverlay(theme, states);
    marks = new ToolPainter(theme, states);
    RGB rgb = theme.palette().rgb(Role.GROUND);
    ground = Rgba.of(rgb.red << 16 | rgb.green << 8 | rgb.blue);
    canvas = new PaintedCanvas(parent, SWT.NONE, theme, Role.GROUND, this::paint);
    pane = new PicturePane(canvas.getDisplay());
    canvas.atEnd(pane::dispose);
  }

  PaintedCanvas control() {
    return canvas;
  }

  /** What shows pictures; any thread. */
  Screen screen() {
    return pane;
  }

  double aspect() {
    return aspect;
  }

  Lens lens(CameraPose pose) {
    Rectangle area = canvas.getClientArea();
    return new Lens(pose, Math.max(1, area.width), Math.max(1, area.height));
  }

  /** Pixels of the picture a point. */
  double scale() {
    return canvas.zoom() / (double) HUNDRED;
  }

  private void paint(GC gc, Rectangle area) {
    aspect = area.width / (double) Math.max(1, area.height);
    double scale = scale();
    pane.zoom((int) Math.round(scale * HUNDRED));
    parts.studio().look(new PictureRequest((int) Math.round(area.width * scale), (int) Math.round(area.height * scale),
        (float) scale, ground));
    Optional<Rendered.Unavailable> none = parts.studio().unavailable();
    Optional<Shot> shot = pane.newest();
    if (none.isPresent()) {
      states.message(gc, area, Health.BAD, "No 3D graphics", (none.get().reason() + " " + none.get().remedy()).strip());
    } else if (shot.isEmpty() || parts.studio().prepares()) {
      states.message(gc, area, Health.WAITING, "Preparing the scene", "The first picture is being drawn.");
    } else {
      PicturePane.paint(gc, area, shot.get().image());
      over(gc, area, shot.get());
    }
  }

  private void over(GC gc, Rectangle area, Shot shot) {
    Lens lens = lens(shot.from());
    overlay.paint(gc, area,
        new SceneOverlay.Scene(parts.model().stage(), lens, shot, SceneOverlay.rate(parts.studio()),
            surface.treeSeen()));
    Optional<Selection> selection = parts.picks().selection();
    overlay.colors(gc, selection.isPresent() ? SceneOverlay.besideCard(area) : area, parts.model().stage());
    marks.paint(gc, selection.isPresent() ? SceneOverlay.besideCard(area) : area, lens, surface.tools());
    selection.ifPresent(s -> overlay.card(gc, area, s));
  }
}
