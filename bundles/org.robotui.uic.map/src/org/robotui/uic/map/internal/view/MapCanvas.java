package org.robotui.uic.map.internal.view;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.scene.Camera;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Commander;
import org.robotui.ui.scene.Layer;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Scene;
import org.robotui.ui.scene.SceneMover;
import org.robotui.ui.scene.ScenePicture;
import org.robotui.ui.scene.Toast;
import org.robotui.ui.scene.Viewport;
import org.robotui.uic.map.internal.Kind;
import org.robotui.uic.map.internal.model.MapModel;
import org.robotui.uic.map.internal.model.MapSnapshot;
import org.robotui.uic.map.internal.model.Note;
import org.robotui.uic.map.internal.model.RobotPlace;

/** The control of a map. Display thread only. */
public final class MapCanvas {
  private static final double TOUCH_PIXELS = 7;
  private static final int MOST_HITS = 3;
  private static final double LARGEST_FIT = 200;
  private static final int MARGIN = 48;

  private final UiContext context;
  private final MapModel model;
  private final MapChoices choices;
  private final Commander commander;
  private final Theme theme;
  private final StateView states;
  private final MapOverlay overlay;
  private final Legend legend;
  private final TeamHands team;
  private final TeamMarks marks;
  private final PaintedCanvas surface;
  private final SceneMover mover;
  private final ScenePicture picture;
  private final Toast toast = new Toast();
  private final Hover hover = new Hover();
  private final SentGoal sent = new SentGoal();
  private Optional<Tool> tool = Optional.empty();
  private String note = "";

  public MapCanvas(
      Composite parent, UiContext context, MapModel model, MapChoices choices, Commander commander, TeamGoals goals,
      MapActions actions) {
    this.context = context;
    this.model = model;
    this.choices = choices;
    this.commander = commander;
    theme = context.theme();
    states = new StateView(theme);
    overlay = new MapOverlay(theme);
    legend = new Legend(theme, model.team());
    team = new TeamHands(this, model.team(), goals);
    marks = new TeamMarks(model.team());
    surface = new PaintedCanvas(parent, theme, this::paint);
    mover = new SceneMover(new Camera(LARGEST_FIT, MARGIN), () -> model.scene().bounds(),
        SceneMover.Following.of(this::following, choices::follow),
        this::repaint);
    picture = new ScenePicture(model.scene(), surface, theme);
    actions.connect(this);
    surface.atEnd(() -> {
      actions.disconnect(this);
      model.scene().dispose();
    });
    new MapInput(this, surface).listen();
  }

  public Control control() {
    return surface;
  }

  /** Paints soon what the last ticks prepared. */
  public void refresh() {
    if (!surface.isDisposed()) {
      sayNote();
      picture.refresh();
      if (following()) {
        // The camera moves with the robot, which is seen by painting.
        surface.requestPaint();
      }
    }
  }

  /**
   * Whether what is painted next is what the last ticks prepared; else it is being painted still, beside other work.
   */
  public boolean upToDate() {
    return picture.upToDate();
  }

  /** Paints soon what hands have changed: the camera, or what lies over the scene. */
  void repaint() {
    if (!surface.isDisposed()) {
      refresh();
      surface.requestPaint();
    }
  }

  boolean following() {
    return choices.options().follow();
  }

  void toggleFollow() {
    choices.follow(!following());
    repaint();
  }

  SceneMover mover() {
    return mover;
  }

  /** Shows the layers of a stream, and where they lie. */
  public void show(SourceId port) {
    List<Layer> layers = model.scene().layers().stream().filter(layer -> layer.id().endsWith(":" + port)).toList();
    layers.forEach(layer -> {
      choices.show(Kind.values()[layer.order()], true);
      choices.show(layer.id(), true);
    });
    layers.stream().flatMap(layer -> layer.entity().bounds().stream()).findFirst()
        .ifPresent(box -> mover.center((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2));
    if (layers.isEmpty()) {
      say(new CommandNotice(Health.WARNING, port + " is not connected to this map"));
    }
    refresh();
  }

  void openLayers() {
    new MapMenu(this, model, choices).openLayers(surface);
  }

  void openMenu(int x, int y) {
    new MapMenu(this, model, choices).open(surface, x, y);
  }

  boolean using(String id) {
    return tool.filter(t -> t.id().equals(id)).isPresent();
  }

  void toggleTool(String id) {
    tool = using(id) ? Optional.empty() : Optional.of(make(id));
    surface.setCursor(tool.isPresent() ? surface.getDisplay().getSystemCursor(SWT.CURSOR_CROSS) : null);
    surface.setFocus();
    repaint();
  }

  Optional<Tool> tool() {
    return tool;
  }

  void endTool() {
    toast.clear();
    sent.clear();
    marks.clear();
    tool.ifPresent(t -> toggleTool(t.id()));
    repaint();
  }

  Hover hover() {
    return hover;
  }

  /** The pointer rests: says what is there. */
  void rest() {
    hover.pointer().ifPresent(p -> hover.say(describe(p)));
    surface.requestPaint();
  }

  List<Scene.Hit> hits(Point pixel) {
    Viewport v = mover.viewport();
    return model.scene().at(v.worldX(pixel.x), v.worldY(pixel.y), TOUCH_PIXELS / v.scale());
  }

  /** A click that moved nothing and used no tool. */
  void click(Point pixel, boolean beside) {
    if (team.isTeam()) {
      team.click(robotAt(pixel), beside);
      repaint();
    }
  }

  private Optional<RobotPlace> robotAt(Point pixel) {
    Viewport v = mover.viewport();
    return model.snapshot().robots().stream()
        .filter(r -> distance(r, v, pixel) < Math.max(TOUCH_PIXELS + 4, robotRadius() * v.scale()))
        .min(Comparator.comparingDouble(r -> distance(r, v, pixel)));
  }

  private static double distance(RobotPlace robot, Viewport v, Point pixel) {
    double dx = robot.fixedFromBase().translation().x() - v.worldX(pixel.x);
    double dy = robot.fixedFromBase().translation().y() - v.worldY(pixel.y);
    return Math.hypot(dx, dy) * v.scale();
  }

  double robotRadius() {
    return choices.options().robotRadius();
  }

  TeamHands team() {
    return team;
  }

  /** Marks where robots were sent. */
  void mark(FrameId fixed, Map<String, RigidTransform> spots) {
    marks.add(fixed, spots);
  }

  void sendGoal(RigidTransform pose) {
    Optional<FrameId> fixed = model.snapshot().fixed();
    if (team.isTeam() && fixed.isPresent()) {
      endTool(t -> t instanceof MeasureTool);
      team.send(fixed.get(), pose, () -> new MapMenu(this, model, choices).askAll(surface, fixed.get(), pose));
      return;
    }
    command(frame -> {
      CommandNotice told = commander.goal(frame, pose);
      if (told.health() == Health.OK) {
        sent.at(frame, pose, System.nanoTime());
        surface.getDisplay().timerExec(SentGoal.PATIENCE_MILLIS + 1, surface::requestPaint);
      }
      return told;
    });
  }

  void sendPose(RigidTransform pose) {
    command(frame -> team.isTeam() ? team.place(frame, pose) : commander.initialPose(frame, pose));
  }

  /** Where a robot would look at a place if nothing else is said: on from where it is now. */
  double usualHeading(double x, double y) {
    return robot()
        .map(r -> r.fixedFromBase().translation())
        .map(at -> Math.atan2(y - at.y(), x - at.x()))
        .orElse(0.0);
  }

  double presentHeading(double x, double y) {
    return (team.isTeam() ? team.meantPlace(model.snapshot().robots()) : robot())
        .map(r -> r.fixedFromBase().rotation().yaw()).orElse(0.0);
  }

  private void paint(GC gc, Rectangle area) {
    MapSnapshot snapshot = model.snapshot();
    mover.settle(area.width, area.height, robot().map(r -> r.fixedFromBase().translation()));
    Painter painter = new Painter(gc, mover.viewport(), theme);
    boolean bare = model.scene().bounds().isEmpty() && !StateView.showsContent(snapshot.state());
    if (!bare) {
      picture.paint(painter);
    }
    sent.paint(painter, snapshot, System.nanoTime());
    marks.paint(painter, snapshot);
    tool.ifPresent(t -> t.paint(painter));
    painter.opacity(1);
    paintState(gc, area, snapshot);
    if (!bare) {
      overlay.corners(gc, mover.viewport(), snapshot, hover.pointer());
      legend.paint(gc, area, snapshot.robots());
    }
    tool.ifPresent(t -> overlay.hint(gc, area, t.hint()));
    toast.at(System.nanoTime()).ifPresent(t -> overlay.toast(gc, area, t));
    if (!hover.lines().isEmpty()) {
      hover.pointer().ifPresent(p -> overlay.card(gc, area, p, hover.lines()));
    }
    if (painter.wantsAgain()) {
      surface.requestPaint();
    }
  }

  private void paintState(GC gc, Rectangle area, MapSnapshot snapshot) {
    boolean empty = model.scene().bounds().isEmpty();
    if (!StateView.showsContent(snapshot.state())) {
      states.paint(gc, area, snapshot.state());
    } else if (empty && !snapshot.notes().isEmpty()) {
      states.message(gc, area, Health.WARNING, "No transform", snapshot.notes().getFirst().text());
    } else {
      if (snapshot.state() instanceof InputState.Stale old && !snapshot.notes().isEmpty()) {
        states.banner(gc, area, Health.STALE, StateView.word(old)); // the notes say of what, and why
      } else {
        states.paint(gc, area, snapshot.state());
      }
      List<Note> notes = new ArrayList<>(snapshot.notes());
      sent.note(snapshot, System.nanoTime()).ifPresent(notes::addFirst);
      overlay.notes(gc, area, notes, snapshot.state() instanceof InputState.Stale, tool.isPresent());
    }
  }

  private List<CardLine> describe(Point pixel) {
    List<CardLine> lines = new ArrayList<>();
    for (Scene.Hit hit : hits(pixel).stream().limit(MOST_HITS).toList()) {
      List<String> words = hit.description().text().lines().toList();
      words.forEach(w -> lines.add(new CardLine(w, w == words.getFirst())));
      model.detail(hit.layer().id(), System.nanoTime()).ifPresent(d -> lines.add(new CardLine(d, false)));
    }
    return lines;
  }

  private Optional<RobotPlace> robot() {
    return model.snapshot().robots().stream().findFirst();
  }

  private Tool make(String id) {
    return switch (id) {
      case MapActions.GOAL -> new PoseTool(id,
          "Goal: press at the place, drag in the direction the robot shall face \u00b7 Esc ends",
          Role.PLAN, this::usualHeading, this::sendGoal);
      case MapActions.POSE -> new PoseTool(id,
          "Pose estimate: press where the robot is, drag in the direction it faces \u00b7 Esc ends",
          Role.WARNING, this::presentHeading, this::sendPose);
      default -> new MeasureTool();
    };
  }

  private void command(Function<FrameId, CommandNotice> sending) {
    CommandNotice told = model.snapshot().fixed().map(sending)
        .orElse(new CommandNotice(Health.BAD, "Not sent: no frame is known yet in which it could be given"));
    endTool(t -> t instanceof MeasureTool);
    say(told);
  }

  private void endTool(Predicate<Tool> kept) {
    tool = tool.filter(kept);
    surface.setCursor(null);
  }

  /** Says for a while what became of something. */
  void say(CommandNotice told) {
    toast.say(told, System.nanoTime());
    surface.getDisplay().timerExec(Toast.MILLIS, surface::requestPaint);
    repaint();
  }

  private void sayNote() {
    String follow = following() ? "follow  \u00b7  " : "";
    String frame = model.snapshot().fixed().map(f -> f.name() + "  \u00b7  ").orElse("");
    String next = follow + frame + Figures.of(1 / mover.viewport().scale(), 3, "m/px");
    if (!next.equals(note)) {
      note = next;
      context.note(next);
    }
  }
}
