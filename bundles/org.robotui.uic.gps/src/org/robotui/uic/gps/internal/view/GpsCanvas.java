package org.robotui.uic.gps.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.entity.gps.GeoText;
import org.robotui.geometry.Vector3;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.display.ListedView;
import org.robotui.ui.layer.LayerListHost;
import org.robotui.ui.scene.KeptViewport;
import org.robotui.ui.scene.Camera;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.SceneControl;
import org.robotui.ui.scene.SceneMover;
import org.robotui.ui.scene.Viewport;
import org.robotui.uic.gps.internal.GpsOptions;
import org.robotui.uic.gps.internal.model.GpsModel;
import org.robotui.uic.gps.internal.model.GpsSnapshot;
import org.robotui.uic.gps.internal.model.Receiver;

/** The control of the GPS view. Display thread only. */
public final class GpsCanvas implements ViewSurface {
  private static final double LARGEST_FIT = 20;
  private static final int MARGIN = 108;
  private static final double TOUCH_PIXELS = 9;

  private final GpsModel model;
  private final GpsChoices choices;
  private final Theme theme;
  private final StateView states;
  private final GpsOverlay overlay;
  private final ListedView view;
  private final SceneControl scene;
  private Optional<Ruler> ruler = Optional.empty();
  private Optional<Point> pointer = Optional.empty();

  public GpsCanvas(Composite parent, UiContext context, GpsModel model, GpsChoices choices) {
    this.model = model;
    this.choices = choices;
    theme = context.theme();
    states = new StateView(theme);
    overlay = new GpsOverlay(theme);
    KeptViewport kept = choices.camera(context, parent.getDisplay());
    SceneControl[] made = new SceneControl[1];
    view = new ListedView(parent, theme, new LayerListHost(model.layers(), model.scene(), this::refresh, this::mover),
        this::listOpen, box -> {
          made[0] = new SceneControl(box, context, model.scene(), new Camera(LARGEST_FIT, MARGIN, kept),
              SceneMover.Following.of(this::following, choices::follow), new Shown());
          return made[0].surface();
        });
    scene = made[0];
    scene.surface().atEnd(kept::write);
    new GpsInput(this, scene.surface()).listen();
  }

  @Override
  public Control control() {
    return view.control();
  }

  /** Paints soon what the last ticks prepared. */
  public void refresh() {
    if (!scene.surface().isDisposed()) {
      view.arrange();
      if (listOpen()) {
        view.pane().show(model.layers().rows(), 0);
      }
      scene.refresh();
    }
  }

  boolean listOpen() {
    return choices.options().list();
  }

  void toggleList() {
    choices.list(!listOpen());
    repaint();
  }

  /** Paints soon what hands have changed. */
  private void repaint() {
    refresh();
    scene.surface().requestPaint();
  }

  boolean following() {
    return choices.options().follow();
  }

  void toggleFollow() {
    choices.follow(!following());
    repaint();
  }

  SceneMover mover() {
    return scene.mover();
  }

  void openMenu() {
    new GpsMenu(this, model, choices).open(scene.surface(), place(pointer));
  }

  boolean measuring() {
    return ruler.isPresent();
  }

  void toggleRuler() {
    ruler = measuring() ? Optional.empty() : Optional.of(new Ruler());
    scene.surface().setCursor(measuring() ? scene.surface().getDisplay().getSystemCursor(SWT.CURSOR_CROSS) : null);
    scene.surface().setFocus();
    repaint();
  }

  void toggleWords() {
    choices.sexagesimal(!choices.options().sexagesimal());
    repaint();
  }

  /** Begins to measure at a place. */
  void measureFrom(GeoPoint place) {
    if (!measuring()) {
      toggleRuler();
    }
    ruler.ifPresent(r -> r.click(place));
    repaint();
  }

  /** The left button at a place: a receiver of the list is followed, the ruler takes its ends; else nothing. */
  boolean click(int x, int y) {
    Optional<Receiver> listed = overlay.receiverAt(x, y);
    listed.ifPresent(r -> choices.follow(r.id()));
    if (listed.isEmpty() && measuring()) {
      place(Optional.of(new Point(x, y))).ifPresent(p -> ruler.ifPresent(r -> r.click(p)));
    }
    repaint();
    return listed.isPresent() || measuring();
  }

  void point(Optional<Point> at) {
    pointer = at;
    place(at).ifPresent(p -> ruler.ifPresent(r -> r.move(p)));
    tell(at.filter(p -> !measuring()).flatMap(this::under));
    scene.surface().requestPaint();
  }

  void center(GeoPoint place) {
    model.snapshot().plane().flatMap(p -> p.point(place)).ifPresent(p -> mover().center(p.east(), p.north()));
  }

  /** Copies the coordinates under the pointer, or of the receiver where the pointer is elsewhere. */
  void copy() {
    place(pointer).or(() -> followed().flatMap(Receiver::place)).ifPresent(p -> Clipboards.copy(GeoText.plain(p)));
  }

  /** What lies under a point: which receiver, and what it says of itself. */
  private Optional<String> under(Point at) {
    return scene.hits(at, TOUCH_PIXELS).stream().findFirst()
        .map(hit -> hit.layer().caption() + "\n" + hit.description().text());
  }

  private void tell(Optional<String> words) {
    if (!Optional.ofNullable(scene.surface().getToolTipText()).equals(words)) {
      scene.surface().setToolTipText(words.orElse(null));
    }
  }

  private Optional<GeoPoint> place(Optional<Point> pixel) {
    Viewport v = mover().viewport();
    return pixel.flatMap(p -> model.snapshot().plane().flatMap(plane -> plane.place(v.worldX(p.x), v.worldY(p.y))));
  }

  private Optional<Receiver> followed() {
    return model.snapshot().followed(choices.options().followed());
  }

  /** What is painted over the layers. */
  private void over(Painter painter, Rectangle area) {
    GC gc = painter.gc();
    GpsSnapshot snapshot = model.snapshot();
    GpsOptions options = choices.options();
    if (shows(snapshot)) {
      snapshot.plane().ifPresent(plane -> ruler.ifPresent(r -> r.paint(painter, plane)));
      overlay.corners(gc, mover().viewport(), snapshot, options, pointer);
      overlay.receivers(gc, area, snapshot, options);
    }
    paintState(gc, area, snapshot);
    ruler.ifPresent(r -> overlay.hint(gc, area, r.hint()));
  }

  private static boolean shows(GpsSnapshot snapshot) {
    return StateView.showsContent(snapshot.state()) && snapshot.plane().isPresent();
  }

  private void paintState(GC gc, Rectangle area, GpsSnapshot snapshot) {
    boolean lost = snapshot.withoutFix() && StateView.showsContent(snapshot.state());
    if (lost && snapshot.receivers().stream().allMatch(r -> r.place().isEmpty())) {
      states.message(gc, area, Health.WARNING, "No fix", names(snapshot.receivers())
          + " sent no position yet. Has the antenna a view of the sky?");
    } else {
      Rectangle free = shows(snapshot) ? overlay.free(area) : area;
      states.paint(gc, free, snapshot.state());
      if (lost && !(StateView.health(snapshot.state()) == Health.STALE)) {
        states.banner(gc, free, Health.WARNING, "no fix, last known place");
      }
    }
  }

  private static String names(List<Receiver> receivers) {
    return String.join(", ", receivers.stream().map(Receiver::name).toList());
  }

  private String note() {
    GpsSnapshot snapshot = model.snapshot();
    String follow = following() ? followed().map(r -> "follow " + r.name() + "  \u00b7  ").orElse("") : "";
    return shows(snapshot)
        ? follow + StateView.word(snapshot.state()) + "  \u00b7  "
            + Figures.of(1 / mover().viewport().scale(), 2, "m/px")
        : StateView.word(snapshot.state());
  }

  /** What is special to this view. */
  private final class Shown implements SceneControl.View {
    @Override
    public boolean shows() {
      return GpsCanvas.shows(model.snapshot());
    }

    @Override
    public Optional<Vector3> followed() {
      return GpsCanvas.this.followed().flatMap(Receiver::at).map(p -> new Vector3(p.east(), p.north(), 0));
    }

    @Override
    public void over(Painter painter, Rectangle area) {
      GpsCanvas.this.over(painter, area);
    }

    @Override
    public String note() {
      return GpsCanvas.this.note();
    }
  }
}
