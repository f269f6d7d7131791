package org.robotui.uic.map.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.robotui.api.UicContext;
import org.robotui.api.frame.Frames;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RobotClock;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.entity.bumper.BumperEntity;
import org.robotui.entity.grid.GridEntity;
import org.robotui.entity.gridmap.GridMapEntity;
import org.robotui.entity.laserscan.LaserScanEntity;
import org.robotui.entity.odometry.OdometryEntity;
import org.robotui.entity.path.PathEntity;
import org.robotui.entity.robot.PoseEntity;
import org.robotui.entity.sonar.SonarEntity;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.StateView;
import org.robotui.ui.scene.FixedFrame;
import org.robotui.ui.scene.Layer;
import org.robotui.ui.scene.Placer;
import org.robotui.ui.scene.Scene;
import org.robotui.uic.map.internal.Kind;
import org.robotui.uic.map.internal.MapOptions;
import org.robotui.uic.map.internal.MapPorts;

/** Takes the newest data, finds their places in the fixed frame and prepares the layers. Worker thread. */
public final class MapModel {
  /** The free space of more robots would cover the floor. */
  private static final int MOST_FANS = 4;

  private final Frames frames;
  private final RobotClock clock;
  private final Scene scene = new Scene();
  private final Feed<GridMap, GridMapEntity> maps;
  private final Feed<LaserScan, LaserScanEntity> scans;
  private final Feed<RangeReadings, SonarEntity> sonars;
  private final Feed<Bumpers, BumperEntity> bumpers;
  private final Feed<Odometry, OdometryEntity> trails;
  private final Feed<Path, PathEntity> paths;
  private final Feed<PoseEstimate, PoseEntity> poses;
  private final Input<NavigationStatus> navigation;
  private final Bodies bodies;
  private final Team team;
  private MapOptions inForce;
  private long epoch;
  private volatile MapSnapshot snapshot = MapSnapshot.NONE;

  public MapModel(UicContext context) {
    frames = context.frames();
    clock = context.clock();
    epoch = clock.epoch();
    team = new Team(context.ruic());
    maps = new Feed<>(Kind.MAP, context.input(MapPorts.MAP), scene, (n, source) -> mapOf(n), MapModel::map,
        (map, tick) -> latest(map.frame(), tick));
    sonars =
        new Feed<>(Kind.SONAR, context.input(MapPorts.SONAR), scene, (n, source) -> new SonarEntity(), MapModel::sonar,
            (readings, tick) -> "");
    bumpers = new Feed<>(Kind.BUMPER, context.input(MapPorts.BUMPER), scene, (n, source) -> new BumperEntity(),
        MapModel::bumper,
        (told, tick) -> latest(told.frame(), tick));
    scans = new Feed<>(Kind.SCAN, context.input(MapPorts.SCAN), scene, (n, source) -> scanOf(source), MapModel::scan,
        (scan, tick) -> "");
    trails = new Feed<>(Kind.TRAIL, context.input(MapPorts.ODOM), scene,
        (n, source) -> new OdometryEntity(team.tint(source).orElse(n)), MapModel::trail,
        (odometry, tick) -> List.of(latest(odometry.frame(), tick), tick.options().trailLength()));
    paths = new Feed<>(Kind.PATH, context.input(MapPorts.PATH), scene, (n, source) -> pathOf(source), MapModel::path,
        (path, tick) -> List.of(latest(path.frame(), tick), tick.robot(path.frame().robot())));
    poses = new Feed<>(Kind.POSE, context.input(MapPorts.POSE), scene, (n, source) -> new PoseEntity(), MapModel::pose,
        (pose, tick) -> latest(pose.frame(), tick));
    navigation = context.input(MapPorts.NAVIGATION);
    bodies = new Bodies(frames, context.input(MapPorts.ODOM), context.input(MapPorts.POSE),
        context.input(MapPorts.FOOTPRINT), scene, team);
    scene.add(new Layer(Kind.GRID.word(), Kind.GRID.ordinal(), Kind.GRID.label(), new GridEntity()));
    inForce = MapOptions.of(context.settings().current());
  }

  private static GridMapEntity mapOf(int number) {
    GridMapEntity entity = new GridMapEntity();
    entity.opacity(number == 0 ? 1 : 0.5);
    return entity;
  }

  private LaserScanEntity scanOf(SourceId source) {
    LaserScanEntity entity = new LaserScanEntity();
    entity.ink(team.ink(source));
    return entity;
  }

  private PathEntity pathOf(SourceId source) {
    PathEntity entity = new PathEntity();
    entity.ink(team.ink(source));
    entity.showLabel(!team.isSeveral());
    return entity;
  }

  /** The robots of the map. */
  public Team team() {
    return team;
  }

  /** Prepares; true where there is something new to show. */
  public boolean tick(long nowNanos, MapOptions options) {
    forgetAfterJump();
    Optional<FrameId> fixed = FixedFrame.choose(options.fixedFrame(), frames, named());
    TickContext plain = new TickContext(nowNanos, options, fixed.map(f -> new Placer(frames, f)), List.of());
    TickContext tick = plain.with(bodies.tick(plain));
    boolean changed = !options.equals(inForce);
    inForce = options;
    for (Feed<?, ?> feed : feeds()) {
      changed |= feed.tick(tick);
    }
    boolean fans = options.fan() && tick.robots().size() <= MOST_FANS;
    scene.layers().forEach(layer -> configure(layer, options, fans));
    MapSnapshot next = new MapSnapshot(fixed, frames.all(), state(), notes(tick), tick.robots(), ways(tick), failures(),
        team.selected());
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

  /** Where a layer's data come from and how old they are; any thread. */
  public Optional<String> detail(String layer, long nowNanos) {
    return feeds().stream().flatMap(f -> f.detail(layer, nowNanos).stream()).findFirst();
  }

  private List<Feed<?, ?>> feeds() {
    return List.of(maps, sonars, scans, trails, paths, poses, bumpers);
  }

  private void forgetAfterJump() {
    if (clock.epoch() != epoch) {
      epoch = clock.epoch();
      scene.layers().forEach(l -> {
        if (l.entity() instanceof OdometryEntity trail) {
          trail.clear();
        }
      });
    }
  }

  private static void configure(Layer layer, MapOptions options, boolean fans) {
    switch (layer.entity()) {
      case LaserScanEntity scan -> scan.showFan(fans);
      case OdometryEntity trail -> trail.showUncertainty(options.uncertainty());
      case GridEntity grid -> layer.show(options.shown().contains(Kind.GRID));
      default -> {}
    }
  }

  private List<FrameId> named() {
    return Stream.of(
        maps.values().stream().map(e -> e.value().frame()),
        trails.values().stream().map(e -> e.value().frame()),
        poses.values().stream().map(e -> e.value().frame()),
        paths.values().stream().map(e -> e.value().frame()),
        scans.values().stream().map(e -> e.value().frame()))
        .flatMap(s -> s)
        .toList();
  }

  private List<Note> notes(TickContext tick) {
    List<Note> notes = new ArrayList<>();
    feeds().forEach(f -> notes.addAll(f.notes(tick)));
    return List.copyOf(notes);
  }

  private List<GoalFailure> failures() {
    return navigation.sources().stream().flatMap(id -> navigation.latest(id).stream())
        .flatMap(said -> GoalFailure.of(said).stream()).toList();
  }

  private Optional<List<Vector3>> ways(TickContext tick) {
    boolean told = paths.states().stream().anyMatch(StateView::showsContent);
    return told ? Optional.of(paths.values().stream().flatMap(e -> end(e.value(), tick).stream()).toList())
        : Optional.empty();
  }

  private static Optional<Vector3> end(Path path, TickContext tick) {
    return path.poses().isEmpty() ? Optional.empty()
        : tick.placer().flatMap(p -> p.latest(path.frame()).found())
            .map(fixedFromPath -> fixedFromPath.apply(path.poses().getLast().translation()));
  }

  private InputState state() {
    return WholeState.of(feeds().stream().flatMap(f -> f.states().stream()).toList());
  }

  private static Object latest(FrameId frame, TickContext tick) {
    return tick.placer().map(p -> p.latest(frame));
  }

  private static Optional<String> map(GridMapEntity entity, Envelope<GridMap> e, TickContext tick) {
    return placed(tick.placer().orElseThrow().latest(e.value().frame()), t -> entity.prepare(e.value(), t));
  }

  private static Optional<String> scan(LaserScanEntity entity, Envelope<LaserScan> e, TickContext tick) {
    return placed(tick.placer().orElseThrow().at(e.value().frame(), e.stamp()), t -> entity.prepare(e.value(), t));
  }

  private static Optional<String> trail(OdometryEntity entity, Envelope<Odometry> e, TickContext tick) {
    return placed(tick.placer().orElseThrow().latest(e.value().frame()),
        t -> entity.prepare(e.value(), t, tick.options().trailLength()));
  }

  private static Optional<String> pose(PoseEntity entity, Envelope<PoseEstimate> e, TickContext tick) {
    return placed(tick.placer().orElseThrow().latest(e.value().frame()), t -> entity.prepare(e.value(), t));
  }

  private static Optional<String> path(PathEntity entity, Envelope<Path> e, TickContext tick) {
    String robot = e.value().frame().robot();
    double speed = tick.robot(robot).map(RobotPlace::speed).orElse(0.0);
    return placed(tick.placer().orElseThrow().latest(e.value().frame()),
        t -> entity.prepare(e.value(), t, tick.position(robot), speed));
  }

  private static Optional<String> bumper(BumperEntity entity, Envelope<Bumpers> e, TickContext tick) {
    return placed(tick.placer().orElseThrow().latest(e.value().frame()), t -> entity.prepare(e.value(), t));
  }

  private static Optional<String> sonar(SonarEntity entity, Envelope<RangeReadings> e, TickContext tick) {
    List<SonarEntity.Placed> placed = new ArrayList<>();
    Optional<String> problem = Optional.empty();
    for (RangeReading reading : e.value().readings()) {
      Placer.Placement at = tick.placer().orElseThrow().at(reading.frame(), e.stamp());
      at.found().ifPresent(t -> placed.add(new SonarEntity.Placed(reading, t)));
      problem = problem.or(() -> at instanceof Placer.Placement.Missing m ? Optional.of(m.reason()) : Optional.empty());
    }
    entity.prepare(placed);
    return problem;
  }

  private static Optional<String> placed(
      Placer.Placement placement, Consumer<RigidTransform> prepare) {
    return switch (placement) {
      case Placer.Placement.At at -> {
        prepare.accept(at.transform());
        yield Optional.empty();
      }
      case Placer.Placement.Missing missing -> Optional.of(missing.reason());
    };
  }
}
