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
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.scene.Camera;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.SceneMover;
import org.robotui.ui.scene.Viewport;
import org.robotui.uic.gps.internal.GpsOptions;
import org.robotui.uic.gps.internal.model.GpsModel;
import org.robotui.uic.gps.internal.model.GpsSnapshot;
import org.robotui.uic.gps.internal.model.Receiver;

/** The control of the GPS view. Display thread only. */
public final class GpsCanvas {
  private static final double LARGEST_FIT = 20;
  private static final int MARGIN = 108;
  private static final double TOUCH_PIXELS = 9;

  private final UiContext context;
  private final GpsModel model;
  private final GpsChoices choices;
  private final Theme theme;
  private final StateView states;
  private final GpsOverlay overlay;
  private final PaintedCanvas surface;
  private final SceneMover mover;
  private Optional<Ruler> ruler = Optional.empty();
  private Optional<Point> pointer = Optional.empty();
  private String note = "";

  public GpsCanvas(Composite parent, UiContext context, GpsModel model, GpsChoices choices, GpsActions actions) {
    this.context = context;
    this.model = model;
    this.choices = choices;
    theme = context.theme();
    states = new StateView(theme);
    overlay = new GpsOverlay(theme);
    surface = new PaintedCanvas(parent, theme, this::paint);
    mover = new SceneMover(new Camera(LARGEST_FIT, MARGIN), () -> model.scene().bounds(),
        SceneMover.Following.of(this::following, choices::follow),
        this::refresh);
    actions.connect(this);
    surface.atEnd(() -> {
      actions.disconnect(this);
      model.scene().dispose();
    });
    new GpsInput(this, surface).listen();
  }

  public Control control() {
    return surface;
  }

  /** Paints soon what the last ticks prepared. */
  public void refresh() {
    if (!surface.isDisposed()) {
      sayNote();
      surface.requestPaint();
    }
  }

  boolean following() {
    return choices.options().follow();
  }

  void toggleFollow() {
    choices.follow(!following());
    refresh();
  }

  SceneMover mover() {
    return mover;
  }

  void openMenu() {
    new GpsMenu(this, model, choices).open(surface, place(pointer));
  }

  boolean measuring() {
    return ruler.isPresent();
  }

  void toggleRuler() {
    ruler = measuring() ? Optional.empty() : Optional.of(new Ruler());
    surface.setCursor(measuring() ? surface.getDisplay().getSystemCursor(SWT.CURSOR_CROSS) : null);
    surface.setFocus();
    refresh();
  }

  void toggleWords() {
    choices.sexagesimal(!choices.options().sexagesimal());
    refresh();
  }

  /** Begins to measure at a place. */
  void measureFrom(GeoPoint place) {
    if (!measuring()) {
      toggleRuler();
    }
    ruler.ifPresent(r -> r.click(place));
    refresh();
  }

  /** The left button at a place: a receiver of the list is followed, the ruler takes its ends; else nothing. */
  boolean click(int x, int y) {
    Optional<Receiver> listed = overlay.receiverAt(x, y);
    listed.ifPresent(r -> choices.follow(r.id()));
    if (listed.isEmpty() && measuring()) {
      place(Optional.of(new Point(x, y))).ifPresent(p -> ruler.ifPresent(r -> r.click(p)));
    }
    refresh();
    return listed.isPresent() || measuring();
  }

  void point(Optional<Point> at) {
    pointer = at;
    place(at).ifPresent(p -> ruler.ifPresent(r -> r.move(p)));
    tell(at.filter(p -> !measuring()).flatMap(this::under));
    surface.requestPaint();
  }

  void center(GeoPoint place) {
    model.snapshot().plane().flatMap(p -> p.point(place)).ifPresent(p -> mover.center(p.east(), p.north()));
  }

  /** Copies the coordinates under the pointer, or of the receiver where the pointer is elsewhere. */
  void copy() {
    place(pointer).or(() -> followed().flatMap(Receiver::place)).ifPresent(p -> Clipboards.copy(GeoText.plain(p)));
  }

  /** What lies under a point: which receiver, and what it says of itself. */
  private Optional<String> under(Point at) {
    Viewport v = mover.viewport();
    return model.scene().at(v.worldX(at.x), v.worldY(at.y), TOUCH_PIXELS / v.scale()).stream().findFirst()
        .map(hit -> hit.layer().caption() + "\n" + hit.description().text());
  }

  private void tell(Optional<String> words) {
    if (!Optional.ofNullable(surface.getToolTipText()).equals(words)) {
      surface.setToolTipText(words.orElse(null));
    }
  }

  private Optional<GeoPoint> place(Optional<Point> pixel) {
    Viewport v = mover.viewport();
    return pixel.flatMap(p -> model.snapshot().plane().flatMap(plane -> plane.place(v.worldX(p.x), v.worldY(p.y))));
  }

  private Optional<Receiver> followed() {
    return model.snapshot().followed(choices.options().followed());
  }

  private void paint(GC gc, Rectangle area) {
    GpsSnapshot snapshot = model.snapshot();
    GpsOptions options = choices.options();
    mover.settle(area.width, area.height,
        followed().flatMap(Receiver::at).map(p -> new Vector3(p.east(), p.north(), 0)));
    if (shows(snapshot)) {
      Painter painter = new Painter(gc, mover.viewport(), theme);
      model.scene().paint(painter);
      painter.opacity(1);
      snapshot.plane().ifPresent(plane -> ruler.ifPresent(r -> r.paint(painter, plane)));
      overlay.corners(gc, mover.viewport(), snapshot, options, pointer);
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

  private void sayNote() {
    GpsSnapshot snapshot = model.snapshot();
    String follow = following() ? followed().map(r -> "follow " + r.name() + "  \u00b7  ").orElse("") : "";
    String next = shows(snapshot)
        ? follow + StateView.word(snapshot.state()) + "  \u00b7  " + Figures.of(1 / mover.viewport().scale(), 2, "m/px")
        : StateView.word(snapshot.state());
    if (!next.equals(note)) {
      note = next;
      context.note(next);
    }
  }
}
