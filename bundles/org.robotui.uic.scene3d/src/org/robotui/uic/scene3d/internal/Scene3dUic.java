package org.robotui.uic.scene3d.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.config.Settings;
import org.robotui.api.show.Subject;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.render.Gl;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.ui.scene.Commander;
import org.robotui.uic.scene3d.internal.camera.CameraMotion;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.model.Edits;
import org.robotui.uic.scene3d.internal.model.Followed;
import org.robotui.uic.scene3d.internal.model.Picks;
import org.robotui.uic.scene3d.internal.model.SceneModel;
import org.robotui.uic.scene3d.internal.model.Stage;
import org.robotui.uic.scene3d.internal.render.FrameScheduler;
import org.robotui.uic.scene3d.internal.view.SceneActions;
import org.robotui.uic.scene3d.internal.view.SceneSurface;
import org.robotui.uic.scene3d.internal.waypoint.Tour;
import org.robotui.uic.scene3d.internal.waypoint.WaypointSender;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

/**
 * A scene: ticks prepare it, the studio has it drawn, the surface paints pictures. While nobody sees it, it asks for
 * nothing.
 */
final class Scene3dUic extends SurfaceUic<SceneSurface> {
  private static final long PROBE_NANOS = 500_000_000L;
  private static final long LONG_NANOS = 30_000_000L;
  /** A tick during which the whole process was halted did not take that long itself. */
  private static final long MOST_ROOM_NANOS = 1_000_000_000L;
  private static final long KEEP_NANOS = 10_000_000_000L;
  private static final long SETTLED_NANOS = 2_500_000_000L;

  private final SceneModel model;
  private final SceneParts parts;
  private final Followed followed;
  private final Driver driver;
  private long preparing;
  private long preparedNanos;
  private long probedNanos;
  private long seenNanos;
  private long fittedNanos;
  private int fits;
  private String figures = "";

  Scene3dUic(UicContext context, Supplier<List<DisplayType>> kinds, Supplier<Optional<Gl>> graphics) {
    Commander commander = new Commander(context, ScenePorts.GOAL, ScenePorts.INITIAL_POSE);
    Waypoints waypoints = new Waypoints(context.settings(),
        new Tour(commander, context.output(ScenePorts.GOAL), context.principal(), told -> tell(context, told)));
    model = new SceneModel(context, kinds, new SceneDisplays(context), waypoints);
    SceneActions.offer(offers(), context.ruic()::reset);
    driver = new Driver(context, waypoints);
    Edits edits = new Edits(context.settings(), model::specs);
    Optional<CameraPose> left = edits.left();
    Optional<CameraPose> start = edits.start().or(() -> left);
    CameraMotion rig = new CameraMotion(start.orElse(CameraPose.START));
    fits = start.isPresent() ? 2 : 0;
    FrameScheduler studio = new FrameScheduler(graphics, rig, System::nanoTime,
        (picture, from) -> surface().ifPresent(s -> s.take(picture, from)),
        () -> surface().ifPresent(SceneSurface::paintSoon));
    followed = new Followed(context.frames(), rig, left.isPresent());
    parts = new SceneParts(model, studio, rig, new Picks(), edits, commander, waypoints,
        new WaypointSender(commander, context.output(ScenePorts.PATH), context.output(ScenePorts.POSES)),
        context.settings(), kinds,
        context.background());
  }

  @Override
  public boolean tick(long nowNanos) {
    driver.tick(nowNanos);
    if (surface().isEmpty() || !seen(surface().get(), nowNanos)) {
      return false;
    }
    if (leavesRoom(nowNanos)) {
      return false;
    }
    long begun = System.nanoTime();
    boolean changed = model.tick(nowNanos);
    preparedNanos = System.nanoTime();
    preparing = preparedNanos - begun;
    Stage stage = model.stage();
    Settings settings = parts.settings().current();
    followed.tick(settings, stage.fixed());
    changed |= parts.picks().keep(stage);
    first(stage, nowNanos);
    parts.studio().thin(settings.flag(SceneOptions.THINNING));
    parts.studio().show(stage, parts.picks().marked());
    String next = Math.round(parts.studio().rate()) + (parts.studio().waits() ? " waiting" : "");
    changed |= !next.equals(figures);
    figures = next;
    return changed;
  }

  /**
   * While the camera moves, what takes long to prepare gets half of the time at most: pictures for the hand come first.
   */
  private boolean leavesRoom(long nowNanos) {
    return preparing > LONG_NANOS && parts.studio().moves()
        && nowNanos - preparedNanos < Math.min(preparing, MOST_ROOM_NANOS);
  }

  /** In the scene where it is seen, else wherever the workbench says such things. */
  private void tell(UicContext context, CommandNotice told) {
    surface().filter(SceneSurface::seen).ifPresentOrElse(shown -> shown.say(told), () -> context.alert(told.text()));
  }

  /** Whether somebody looks; after a while without, all is given up. */
  private boolean seen(SceneSurface shown, long nowNanos) {
    if (nowNanos - probedNanos > PROBE_NANOS) {
      probedNanos = nowNanos;
      shown.probe();
    }
    if (shown.seen()) {
      seenNanos = nowNanos;
      return true;
    }
    if (nowNanos - seenNanos > KEEP_NANOS) {
      model.rest();
      parts.studio().rest();
    }
    return false;
  }

  /** Looks at what came first, and again when the rest has come, unless hands have taken the camera. */
  private void first(Stage stage, long nowNanos) {
    boolean due = fits == 0 || fits == 1 && nowNanos - fittedNanos > SETTLED_NANOS;
    if (due && !surface().get().touched()) {
      stage.fed().ifPresent(box -> {
        fits++;
        fittedNanos = nowNanos;
        parts.rig().go(parts.rig().aim().fit(box, surface().get().aspect()), nowNanos);
      });
    }
  }

  @Override
  protected SceneSurface open(Composite parent, UiContext ui) {
    return new SceneSurface(parent, ui, parts);
  }

  @Override
  protected void refresh(SceneSurface shown) {
    shown.refresh();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("F", "Focus on the selection"),
        new ViewKey("0, Home", "Show all"),
        new ViewKey("1, 2, 3", "Orbit, fly, top down"),
        new ViewKey("V", "Choose camera and view"),
        new ViewKey("G", "Send a goal"),
        new ViewKey("P", "Set the pose estimate"),
        new ViewKey("M", "Measure"),
        new ViewKey("R", "Place waypoints"),
        new ViewKey("L", "Show the list of displays"),
        new ViewKey("W A S D, Q E", "Move the camera"),
        new ViewKey("+, -", "Zoom"),
        new ViewKey("Esc", "Clear the selection, end the tool"));
  }

  @Override
  public void show(String showing, Subject subject) {
    switch (subject) {
      case Subject.Stream stream -> surface().ifPresent(s -> s.show(stream.port()));
      case Subject.Frame frame -> followed
          .where(frame.frame(), parts.settings().current(), parts.model().stage().fixed())
          .ifPresent(place -> surface().ifPresent(s -> s.look(place.translation())));
      case Subject.Node node -> {}
    }
  }

  @Override
  public void close() {
    model.rest();
    parts.studio().close();
  }
}
