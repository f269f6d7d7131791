package org.robotui.uic.scene3d.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.SourceId;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Rendered;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.display.DisplayKind;
import org.robotui.ui.display.DisplayList;
import org.robotui.ui.display.DisplayPane;
import org.robotui.ui.display.DisplayRow;
import org.robotui.ui.display.ListedView;
import org.robotui.ui.display.SourceName;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.SceneParts;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.camera.Lens;
import org.robotui.uic.scene3d.internal.model.Kinds;

/** The control of a scene: the list of displays, and the picture. Display thread, where nothing else is said. */
public final class SceneSurface implements ViewSurface {
  private static final int REST_MILLIS = 500;

  private final UiContext context;
  private final SceneParts parts;
  private final ListedView view;
  private final SceneCanvas canvas;
  private final Tools tools;
  private final SceneMenus menus;
  private final Display display;
  private final Runnable keepCamera = this::keepCamera;
  private volatile boolean seen = true;
  private volatile boolean touched;
  private boolean moved;
  private String note = "";

  /** Makes it. */
  public SceneSurface(Composite parent, UiContext context, SceneParts parts) {
    this.context = context;
    this.parts = parts;
    display = parent.getDisplay();
    tools = new Tools(parts, this::say, this::refresh);
    menus = new SceneMenus(this, parts);
    SceneCanvas[] made = new SceneCanvas[1];
    view = new ListedView(parent, context.theme(), new Listed(), this::treeOpen, box -> {
      made[0] = new SceneCanvas(box, context.theme(), this, parts);
      return made[0].control();
    });
    canvas = made[0];
    new SceneInput(this, parts).listen();
    view.control().addListener(SWT.Dispose, e -> end());
    parts.studio().again();
  }

  @Override
  public Control control() {
    return view.control();
  }

  /** Shows what the last tick made. */
  public void refresh() {
    if (!view.control().isDisposed()) {
      view.arrange();
      view.pane().show(parts.model().stage().rows(), parts.model().stage().bytes());
      canvas.control().requestPaint();
      sayNote();
    }
  }

  /** A picture came; on the thread that hands it over. */
  public void take(Rendered.Picture picture, CameraPose from) {
    canvas.screen().take(picture, from);
  }

  /** Something is to be said or shown; any thread. */
  public void paintSoon() {
    canvas.control().requestPaint();
  }

  /** Says for a moment what became of something; any thread. */
  public void say(CommandNotice told) {
    if (!display.isDisposed()) {
      display.asyncExec(() -> {
        if (!view.control().isDisposed()) {
          tools.say(told);
        }
      });
    }
  }

  /** Looks soon whether it is seen; any thread. */
  public void probe() {
    if (!display.isDisposed()) {
      display.asyncExec(() -> {
        boolean before = seen;
        seen = !view.control().isDisposed() && view.control().isVisible();
        if (seen && !before) {
          canvas.control().requestPaint();
        }
      });
    }
  }

  /** Whether it was seen when it was looked last; any thread. */
  public boolean seen() {
    return seen;
  }

  /** Whether hands have taken the camera; any thread. */
  public boolean touched() {
    return touched;
  }

  /** Width of the picture in terms of its height; any thread. */
  public double aspect() {
    return canvas.aspect();
  }

  void touch() {
    touched = true;
    moved = true;
    display.timerExec(REST_MILLIS, keepCamera);
  }

  private void keepCamera() {
    if (moved && parts.edits().start().isEmpty()) {
      parts.edits().left(parts.rig().aim());
    }
    moved = false;
  }

  private void end() {
    seen = false;
    keepCamera();
  }

  SceneCanvas surface() {
    return canvas;
  }

  Control canvas() {
    return canvas.control();
  }

  Tools tools() {
    return tools;
  }

  SceneMenus menus() {
    return menus;
  }

  /** As the camera is now; places in points. */
  Lens lens() {
    return canvas.lens(parts.rig().at(System.nanoTime()));
  }

  /** Shows the display of a stream, after adding one where there is none, and goes to it in list and picture. */
  public void show(SourceId port) {
    Optional<DisplayRow> there = parts.model().stage().rows().stream()
        .filter(row -> row.spec().sources().stream().anyMatch(written -> SourceName.fits(written, port))).findFirst();
    Optional<String> display = there.map(row -> row.spec().id())
        .or(() -> parts.model().kindFor(port).map(kind -> parts.edits().add(kind.id(), SourceName.of(port))));
    display.ifPresent(id -> {
      parts.edits().change(id, spec -> spec.show(true));
      parts.edits().tree(true);
      view.pane().choose(id);
      parts.model().stage().bounds(id).ifPresent(box -> go(parts.rig().aim().fit(box, aspect())));
    });
    refresh();
  }

  /** Turns the camera to a place. */
  public void look(Vector3 place) {
    go(parts.rig().aim().at(place));
  }

  void fit() {
    parts.model().stage().bounds().ifPresent(box -> go(parts.rig().aim().fit(box, aspect())));
  }

  /** Looks at what is selected; else at all. */
  void focusSelection() {
    parts.picks().selection().ifPresentOrElse(
        s -> s.part().bounds().filter(b -> b.radius() > 0.01)
            .ifPresentOrElse(box -> go(parts.rig().aim().fit(box.grown(box.radius() / 2), aspect())),
                () -> go(parts.rig().aim().at(s.place()))),
        this::fit);
  }

  void go(CameraPose pose) {
    touch();
    parts.rig().go(pose, System.nanoTime());
    parts.studio().moved();
    refresh();
  }

  boolean following() {
    return !parts.settings().current().text(SceneOptions.FOLLOW).isBlank();
  }

  boolean treeOpen() {
    return parts.settings().current().flag(SceneOptions.TREE);
  }

  /** It may be open, and yet there is no room for it beside the picture. */
  boolean treeSeen() {
    return view.listSeen();
  }

  void toggleTree() {
    parts.edits().tree(!treeOpen());
    refresh();
  }

  /** What the list of displays needs of the scene. */
  private final class Listed implements DisplayPane.Host {
    @Override
    public String noun() {
      return "display";
    }

    @Override
    public DisplayList list() {
      return parts.edits();
    }

    @Override
    public List<DisplayKind> kinds() {
      return Kinds.of(parts.kinds().get());
    }

    @Override
    public void refresh() {
      SceneSurface.this.refresh();
    }

    @Override
    public void showAllOf(String id) {
      parts.model().stage().bounds(id).ifPresent(box -> go(parts.rig().aim().fit(box, aspect())));
    }
  }

  private void sayNote() {
    String frame = parts.model().stage().fixed().map(f -> f.name()).orElse("no frame");
    String next = frame + "  \u00b7  " + SceneOverlay.rate(parts.studio());
    if (!next.equals(note)) {
      note = next;
      context.note(next);
    }
  }
}
