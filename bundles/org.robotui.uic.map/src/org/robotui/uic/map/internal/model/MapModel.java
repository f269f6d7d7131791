package org.robotui.uic.map.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;
import org.robotui.api.UicContext;
import org.robotui.api.frame.Frames;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RobotClock;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.Path;
import org.robotui.geometry.Vector3;
import org.robotui.ui.StateView;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.layer.LayerInputs;
import org.robotui.ui.layer.LayerStack;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.SeenRobot;
import org.robotui.ui.scene.FixedFrame;
import org.robotui.ui.scene.Placer;
import org.robotui.ui.scene.Scene;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.MapPorts;

/** Finds the fixed frame and the robots, and has the layers prepared. Worker thread. */
public final class MapModel {
  private final Frames frames;
  private final RobotClock clock;
  private final Scene scene = new Scene();
  private final LayerStack layers;
  private final Input<Path> paths;
  private final Input<NavigationStatus> navigation;
  private final Robots robots;
  private final Team team;
  private final PastPlaces past;
  private volatile MapOptions inForce;
  private long epoch;
  private volatile MapSnapshot snapshot = MapSnapshot.NONE;

  /** A map of what bundles bring layers for. */
  public MapModel(UicContext context, Supplier<List<LayerType>> kinds) {
    frames = context.frames();
    clock = context.clock();
    epoch = clock.epoch();
    team = new Team(context.ruic());
    inForce = MapOptions.of(context.settings().current());
    paths = context.input(MapPorts.PATH);
    navigation = context.input(MapPorts.NAVIGATION);
    robots = new Robots(frames, context.input(MapPorts.ODOM), context.input(MapPorts.POSE), team);
    past = new PastPlaces(context, team);
    layers = new LayerStack(LayerType.Ground.FRAME, scene, context,
        new LayerInputs(context, MapPorts.LAYERS, MapPorts.DATA), kinds, new Rules());
  }

  /** What the older settings of the map, and its robots, say of layers. */
  private final class Rules implements LayerStack.Rules {
    @Override
    public DisplaySpec begin(DisplaySpec spec) {
      return inForce.begin(spec);
    }

    @Override
    public OptionalInt trace(SourceId source) {
      return team.tint(source);
    }
  }

  /** The robots of the map. */
  public Team team() {
    return team;
  }

  /** What is listed. */
  public LayerStack layers() {
    return layers;
  }

  /** Prepares; true where there is something new to show. */
  public boolean tick(long nowNanos, MapOptions options) {
    boolean changed = !options.equals(inForce);
    inForce = options;
    boolean reset = clock.epoch() != epoch;
    epoch = clock.epoch();
    List<FrameId> named = layers.take(reset);
    Optional<FrameId> fixed = FixedFrame.choose(options.fixedFrame(), frames, named);
    Optional<Placer> placer = fixed.map(f -> new Placer(frames, f));
    List<SeenRobot> seen = placer.map(robots::find).orElse(List.of());
    changed |= layers.prepare(placer, Optional.empty(), seen, nowNanos, reset);
    MapSnapshot next = new MapSnapshot(fixed, frames.all(), WholeState.of(layers.states()), layers.notes(), seen,
        ways(placer), failures(), team.selected(), placer.map(past::find).orElse(List.of()));
    changed |= !next.equals(snapshot);
    snapshot = next;
    return changed;
  }

  /** What the last tick found; any thread. */
  public MapSnapshot snapshot() {
    return snapshot;
  }

  /** The layers; any thread. */
  public Scene scene() {
    return scene;
  }

  private List<GoalFailure> failures() {
    return navigation.sources().stream().flatMap(id -> navigation.latest(id).stream())
        .flatMap(said -> GoalFailure.of(said).stream()).toList();
  }

  private Optional<List<Vector3>> ways(Optional<Placer> placer) {
    List<SourceId> sources = paths.sources();
    boolean told =
        StateView.showsContent(paths.state()) || sources.stream().map(paths::state).anyMatch(StateView::showsContent);
    return told
        ? Optional.of(sources.stream().flatMap(id -> paths.latest(id).stream())
            .flatMap(e -> end(e.value(), placer).stream()).toList())
        : Optional.empty();
  }

  private static Optional<Vector3> end(Path path, Optional<Placer> placer) {
    return path.poses().isEmpty() ? Optional.empty()
        : placer.flatMap(p -> p.latest(path.frame()).found())
            .map(fixedFromPath -> fixedFromPath.apply(path.poses().getLast().translation()));
  }
}
