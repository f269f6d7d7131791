package org.robotui.uic.camera.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RobotClock;
import org.robotui.entity.image.Legend;
import org.robotui.entity.image.Picture;
import org.robotui.ui.ImageFill;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.CandidateChooser;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.SaveDialog;

/** What is seen of the view while it is shown. Display thread. */
final class CameraSurface implements ViewSurface {
  private static final double PIXELS_SHOWN_FROM = 3;
  private static final double MARKED_FROM = 6;
  private static final int BANNER = 28;
  private static final double PERCENT = 100;

  private final UiContext context;
  private final CameraChoices choices;
  private final Saver saver;
  private final IntConsumer seenFrom;
  private final StateView states;
  private final RobotClock clock;
  private final Labels labels;
  private final HoverBar bar;
  private final LegendBar legends;
  private final Composite root;
  private final StackLayout stack = new StackLayout();
  private final PaintedCanvas canvas;
  private final CandidateChooser chooser;
  private final Screen screen;
  private final Navigation navigation;
  private Shot shot = Shot.NOTHING;

  /**
   * A surface.
   *
   * @param clock of the robot, by which pictures grow old
   * @param chosen is given what the user wants connected
   * @param seenFrom is given the edge of blocks of pixels that are one on the screen
   */
  CameraSurface(Composite parent, UiContext context, RobotClock clock, CameraChoices choices, Saver saver,
      Consumer<SourceId> chosen, IntConsumer seenFrom) {
    this.context = context;
    this.clock = clock;
    this.choices = choices;
    this.saver = saver;
    this.seenFrom = seenFrom;
    this.states = new StateView(context.theme());
    this.labels = new Labels(context.theme());
    this.bar = new HoverBar(context.theme());
    this.legends = new LegendBar(context.theme());
    this.root = new Composite(parent, SWT.NONE);
    root.setLayout(stack);
    this.canvas = new PaintedCanvas(root, context.theme(), this::paint);
    this.chooser = new CandidateChooser(root, context.theme(), chosen);
    this.navigation = new Navigation(canvas, choices.options().zoom(), this::stage);
    stack.topControl = canvas;
    listen();
    screen = new Screen(canvas.getDisplay());
    canvas.atEnd(screen::dispose);
  }

  @Override
  public Control control() {
    return root;
  }

  PaintedCanvas canvas() {
    return canvas;
  }

  /** Makes what will be painted ready. On the tick. */
  void prepare(Shot next) {
    next.seen().map(Shot.Shown::pixels).ifPresent(screen::prepare);
  }

  void show(Shot next) {
    if (canvas.isDisposed()) {
      return;
    }
    shot = next;
    context.note(next.note());
    chooser.ask(next.state().explanation(), next.candidates());
    Control top = next.candidates().isEmpty() ? canvas : chooser;
    if (stack.topControl != top) {
      stack.topControl = top;
      root.layout();
    }
    canvas.redraw();
  }

  void redraw() {
    canvas.redraw();
  }

  /** Whether the picture is shown as a mode says. */
  boolean sees(ZoomMode mode) {
    return navigation.view().mode() == mode && navigation.view().untouched();
  }

  void see(ZoomMode mode) {
    choices.zoom(mode);
    navigation.see(mode);
  }

  void openMenu() {
    new CameraMenu(this, choices).open(canvas, shot.seen().map(Shot.Shown::picture));
  }

  void copy() {
    picture().ifPresent(picture -> Clipboards.copy(picture.pixels()));
  }

  void save(Saver.Part part) {
    String name = part == Saver.Part.COLORS ? "picture.png" : "numbers.png";
    picture().ifPresent(picture -> SaveDialog.ask(canvas, "Save the picture", name, "*.png")
        .ifPresent(file -> saver.save(picture, part, file.toString())));
  }

  private Optional<Picture> picture() {
    return shot.shown().map(Shot.Shown::picture);
  }

  private Optional<Legend> legend() {
    return shot.seen().flatMap(s -> s.picture().legend());
  }

  private Optional<Stage> stage() {
    return shot.seen().map(s -> stage(s, canvas.getClientArea())).filter(s -> !s.area().isEmpty());
  }

  private Stage stage(Shot.Shown shown, Rectangle area) {
    return new Stage(area, shown.picture().width(), shown.picture().height(), 1 / zoom());
  }

  /** Pixels of the screen to a point. */
  private double zoom() {
    return canvas.zoom() / PERCENT;
  }

  private void listen() {
    canvas.addListener(SWT.MouseDown, this::down);
    canvas.addListener(SWT.MouseVerticalWheel, this::wheel);
    canvas.addListener(SWT.MouseMove, e -> hint(bar.at(e.x, e.y).map(HoverBar.Cell::hint)));
    canvas.addListener(SWT.MouseDoubleClick, e -> {
      if (bar.at(e.x, e.y).isEmpty()) {
        see(choices.options().zoom());
      }
    });
    canvas.addListener(SWT.MenuDetect, e -> {
      e.doit = false;
      openMenu();
    });
    canvas.addListener(SWT.KeyDown, this::key);
    navigation.listen();
  }

  private void down(Event event) {
    canvas.setFocus();
    Optional<HoverBar.Cell> cell = event.button == 1 ? bar.at(event.x, event.y) : Optional.empty();
    cell.ifPresentOrElse(c -> {
      c.run().run();
      canvas.redraw();
    }, () -> navigation.grab(event));
  }

  private void wheel(Event event) {
    event.doit = false;
    Optional<Legend> under = legend().filter(l -> legends.contains(event.x, event.y));
    under.ifPresentOrElse(
        legend -> legends.turned(legend, event.y, event.count).ifPresent(range -> choices.range(Optional.of(range))),
        () -> navigation.wheel(event));
  }

  private void hint(Optional<String> words) {
    String now = words.orElse(null);
    if (!Optional.ofNullable(canvas.getToolTipText()).equals(words)) {
      canvas.setToolTipText(now);
    }
  }

  private void key(Event event) {
    switch (Character.toLowerCase(event.character)) {
      case '0' -> see(ZoomMode.FIT);
      case '1' -> see(ZoomMode.ACTUAL);
      case '2' -> see(ZoomMode.FILL);
      case 'c' -> legend().ifPresent(l -> choices.nextMap(l.map()));
      case 'r' -> legend().ifPresent(this::holdOrFollow);
      case 'i' -> choices.toggle(CameraOptions.READ_OUT);
      case 'd' -> choices.toggle(CameraOptions.DETAILS);
      case 'l' -> choices.toggle(CameraOptions.LEGEND);
      default -> {
        if (event.keyCode == SWT.HOME) {
          see(ZoomMode.FIT);
        }
      }
    }
    canvas.redraw();
  }

  private void holdOrFollow(Legend legend) {
    choices.range(legend.follows() ? Optional.of(legend.span()) : Optional.empty());
  }

  private void paint(GC gc, Rectangle area) {
    CameraOptions options = choices.options();
    navigation.follow(options.zoom());
    shot.seen().filter(s -> !area.isEmpty()).ifPresent(shown -> paint(gc, area, shown, options));
    states.paint(gc, area, shot.state());
    if (shot.seen().isPresent() && navigation.pointer().isPresent()) {
      int top = area.y + Theme.EDGE + (shot.state() instanceof InputState.Stale ? BANNER : 0);
      bar.paint(gc, area, top, cells(), navigation.pointer());
    } else {
      bar.hide();
    }
    shot.message().ifPresent(text -> labels.message(gc, area, text));
  }

  private void paint(GC gc, Rectangle area, Shot.Shown shown, CameraOptions options) {
    Picture picture = shown.picture();
    Placement at = navigation.view().in(stage(shown, area));
    paint(gc, area, shown.pixels(), at, picture, options.smooth());
    if (options.legend() && picture.legend().isPresent()) {
      legends.paint(gc, area, picture.legend().get());
    } else {
      legends.hide();
    }
    if (options.details()) {
      labels.details(gc, area, shown, shot.state(), clock.ageSeconds(shown.receivedNanos(), System.nanoTime()));
    }
    if (options.readOut()) {
      navigation.pointer().map(p -> at.pixel(p.x, p.y))
          .filter(p -> new Rectangle(0, 0, picture.width(), picture.height()).contains(p))
          .ifPresent(p -> readOut(gc, area, picture, p, at));
    }
  }

  private void paint(GC gc, Rectangle area, ImageData pixels, Placement at, Picture picture, boolean smooth) {
    double dots = at.scale() * zoom();
    seenFrom.accept(Math.max(1, (int) Math.floor(1 / dots + 1e-6)));
    double shrunk = (double) picture.width() / pixels.width;
    Placement small = new Placement(at.left(), at.top(), at.scale() * shrunk);
    Rectangle seen = small.seen(area, pixels.width, pixels.height);
    gc.setInterpolation(smooth && at.scale() < PIXELS_SHOWN_FROM ? SWT.LOW : SWT.NONE);
    gc.setAlpha(StateView.contentAlpha(shot.state()));
    ImageFill.draw(gc, screen.image(pixels), seen, small.region(seen.x, seen.y, seen.width, seen.height));
    gc.setAlpha(255);
  }

  private void readOut(GC gc, Rectangle area, Picture picture, Point pixel, Placement at) {
    if (at.scale() >= MARKED_FROM) {
      Rectangle marked = at.region(pixel.x, pixel.y, 1, 1);
      gc.setLineWidth(1);
      gc.setForeground(context.theme().color(Role.ACCENT));
      gc.drawRectangle(marked.x, marked.y, marked.width - 1, marked.height - 1);
    }
    labels.pixel(gc, area, picture, pixel, shot.info());
  }

  private List<HoverBar.Cell> cells() {
    List<HoverBar.Cell> cells = new ArrayList<>();
    String[] keys = {"0", "2", "1"};
    String[] words = {"Show all of the picture", "Fill the view", "A pixel of the picture on a pixel of the screen"};
    for (ZoomMode mode : ZoomMode.values()) {
      int i = mode.ordinal();
      cells.add(new HoverBar.Cell(mode.label(), sees(mode), words[i] + " (" + keys[i] + ")", () -> see(mode)));
    }
    legend().ifPresent(l -> {
      cells.add(new HoverBar.Cell(l.map().label(), false, "Other colours (C)", () -> choices.nextMap(l.map())));
      cells.add(new HoverBar.Cell(l.follows() ? "Auto range" : "Fixed range", !l.follows(),
          l.follows() ? "Fix the range (R)" : "Let the range follow the picture (R)", () -> holdOrFollow(l)));
    });
    cells.add(new HoverBar.Cell("\u2026", false, "All settings of the view", this::openMenu));
    return cells;
  }
}
