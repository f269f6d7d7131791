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
import org.robotui.geometry.Vector3;
import org.robotui.ui.ColorBars;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.display.ListedView;
import org.robotui.ui.layer.LayerListHost;
import org.robotui.ui.layer.LayerNote;
import org.robotui.ui.layer.SeenRobot;
import org.robotui.ui.scene.KeptViewport;
import org.robotui.ui.scene.Camera;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Commander;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Scene;
import org.robotui.ui.scene.SceneControl;
import org.robotui.ui.scene.SceneMover;
import org.robotui.ui.scene.Toast;
import org.robotui.ui.scene.Viewport;
import org.robotui.uic.map.internal.model.MapModel;
import org.robotui.uic.map.internal.model.MapSnapshot;

/** The control of a map. Display thread only. */
public final class MapCanvas implements ViewSurface {
  private static final double TOUCH_PIXELS = 7;
  private static final int MOST_HITS = 3;
  private static final double LARGEST_FIT = 200;
  private static final int MARGIN = 48;

  private final MapModel model;
  private final MapChoices choices;
  private final Commander commander;
  private final Theme theme;
  private final StateView states;
  private final MapOverlay overlay;
  private final Legend legend;
  private final ColorBars colors;
  private final TeamHands team;
  private final TeamMarks marks;
  private final PastMarks past;
  private final ListedView view;
  private final SceneControl scene;
  private final Toast toast = new Toast();
  private final Hover hover = new Hover();
  private final SentGoal sent = new SentGoal();
  private Optional<Tool> tool = Optional.empty();

  public MapCanvas(
      Composite parent, UiContext context, MapModel model, MapChoices choices, Commander commander, TeamGoals goals) {
    this.model = model;
    this.choices = choices;
    this.commander = commander;
    theme = context.theme();
    states = new StateView(theme);
    overlay = new MapOverlay(theme);
    legend = new Legend(theme, model.team());
    colors = new ColorBars(theme);
    team = new TeamHands(this, model.team(), goals);
    marks = new TeamMarks(model.team());
    past = new PastMarks(model.team());
    KeptViewport kept = choices.camera(context, parent.getDisplay());
    SceneControl[] made = new SceneControl[1];
    view = new ListedView(parent, theme, new LayerListHost(model.layers(), model.scene(), this::refresh, this::mover),
        () -> choices.options().list(), box -> {
          made[0] = new SceneControl(box, context, model.scene(), new Camera(LARGEST_FIT, MARGIN, kept),
              SceneMover.Following.of(this::following, choices::follow), new Shown());
          return made[0].surface();
        });
    scene = made[0];
    scene.surface().atEnd(kept::write);
    new MapInput(this, scene.surface()).listen();
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

  /** Paints soon what hands have changed: the camera, or what lies over the scene. */
  void repaint() {
    scene.repaint();
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

  /** Shows the layers of a stream, after adding one where there is none, and where they lie. */
  public void show(SourceId port) {
    List<String> layers = model.layers().of(port);
    if (layers.isEmpty()) {
      layers = model.layers().add(port).stream().toList();
    }
    if (layers.isEmpty()) {
      say(new CommandNotice(Health.WARNING, "No layer shows " + port));
    }
    layers.forEach(id -> {
      model.layers().list().change(id, spec -> spec.show(true));
      view.pane().choose(id);
    });
    layers.stream().findFirst().ifPresent(this::goTo);
    refresh();
  }

  private void goTo(String layer) {
    model.scene().find(layer).flatMap(l -> l.entity().bounds())
        .ifPresent(box -> mover().center((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2));
  }

  boolean listOpen() {
    return choices.options().list();
  }

  void toggleList() {
    choices.list(!listOpen());
    refresh();
  }

  void openMenu(int x, int y) {
    new MapMenu(this, model, choices).open(scene.surface(), x, y);
  }

  boolean using(String id) {
    return tool.filter(t -> t.id().equals(id)).isPresent();
  }

  void toggleTool(String id) {
    tool = using(id) ? Optional.empty() : Optional.of(make(id));
    scene.surface().setCursor(tool.isPresent() ? scene.surface().getDisplay().getSystemCursor(SWT.CURSOR_CROSS) : null);
    scene.surface().setFocus();
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
    scene.surface().requestPaint();
  }

  List<Scene.Hit> hits(Point pixel) {
    return scene.hits(pixel, TOUCH_PIXELS);
  }

  /** A click that moved nothing and used no tool. */
  void click(Point pixel, boolean beside) {
    if (team.isTeam()) {
      team.click(robotAt(pixel), beside);
      repaint();
    }
  }

  private Optional<SeenRobot> robotAt(Point pixel) {
    Viewport v = mover().viewport();
    return model.snapshot().robots().stream()
        .filter(r -> distance(r, v, pixel) < Math.max(TOUCH_PIXELS + 4, robotRadius() * v.scale()))
        .min(Comparator.comparingDouble(r -> distance(r, v, pixel)));
  }

  private static double distance(SeenRobot robot, Viewport v, Point pixel) {
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
      team.send(fixed.get(), pose, () -> new MapMenu(this, model, choices).askAll(scene.surface(), fixed.get(), pose));
      return;
    }
    command(frame -> {
      CommandNotice told = commander.goal(frame, pose);
      if (told.health() == Health.OK) {
        sent.at(frame, pose, System.nanoTime());
        scene.surface().getDisplay().timerExec(SentGoal.PATIENCE_MILLIS + 1, scene.surface()::requestPaint);
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

  private boolean isBare() {
    return model.scene().bounds().isEmpty() && !StateView.showsContent(model.snapshot().state());
  }

  /** What is painted over the layers. */
  private void over(Painter painter, Rectangle area) {
    GC gc = painter.gc();
    MapSnapshot snapshot = model.snapshot();
    sent.paint(painter, snapshot, System.nanoTime());
    marks.paint(painter, snapshot);
    past.paint(painter, snapshot.past());
    tool.ifPresent(t -> t.paint(painter));
    painter.opacity(1);
    paintState(gc, area, snapshot);
    if (!isBare()) {
      overlay.corners(gc, mover().viewport(), snapshot, hover.pointer());
      legend.paint(gc, area, snapshot.robots());
      colors.paint(gc, area, model.layers().colors());
    }
    tool.ifPresent(t -> overlay.hint(gc, area, t.hint()));
    toast.at(System.nanoTime()).ifPresent(t -> overlay.toast(gc, area, t));
    if (!hover.lines().isEmpty()) {
      hover.pointer().ifPresent(p -> overlay.card(gc, area, p, hover.lines()));
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
      List<LayerNote> notes = new ArrayList<>(snapshot.notes());
      sent.note(snapshot, System.nanoTime()).ifPresent(notes::addFirst);
      overlay.notes(gc, area, notes, snapshot.state() instanceof InputState.Stale, tool.isPresent());
    }
  }

  private List<CardLine> describe(Point pixel) {
    List<CardLine> lines = new ArrayList<>();
    for (Scene.Hit hit : hits(pixel).stream().limit(MOST_HITS).toList()) {
      List<String> words = hit.description().text().lines().toList();
      words.forEach(w -> lines.add(new CardLine(w, w == words.getFirst())));
      model.layers().detail(hit.layer().id(), System.nanoTime()).ifPresent(d -> lines.add(new CardLine(d, false)));
    }
    return lines;
  }

  private Optional<SeenRobot> robot() {
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
    scene.surface().setCursor(null);
  }

  /** Says for a while what became of something. */
  void say(CommandNotice told) {
    toast.say(told, System.nanoTime());
    scene.surface().getDisplay().timerExec(Toast.MILLIS, scene.surface()::requestPaint);
    repaint();
  }

  private String note() {
    String follow = following() ? "follow  \u00b7  " : "";
    String frame = model.snapshot().fixed().map(f -> f.name() + "  \u00b7  ").orElse("");
    return follow + frame + Figures.of(1 / mover().viewport().scale(), 3, "m/px");
  }

  /** What is special to a map. */
  private final class Shown implements SceneControl.View {
    @Override
    public boolean shows() {
      return !isBare();
    }

    @Override
    public Optional<Vector3> followed() {
      return robot().map(SeenRobot::at);
    }

    @Override
    public void over(Painter painter, Rectangle area) {
      MapCanvas.this.over(painter, area);
    }

    @Override
    public String note() {
      return MapCanvas.this.note();
    }
  }
}
