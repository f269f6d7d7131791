package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.frame.Frames;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RobotClock;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Framed;
import org.robotui.data.joint.RobotDescription;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.shape.Part;
import org.robotui.ui.display.Automatic;
import org.robotui.ui.display.DisplayCodec;
import org.robotui.ui.display.DisplayRow;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.display.SourceChoice;
import org.robotui.ui.scene.FixedFrame;
import org.robotui.uic.scene3d.internal.SceneOptions;
import org.robotui.uic.scene3d.internal.ScenePorts;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

/** Drains, routes to displays, and makes the stage. Worker thread, where nothing else is said. */
public final class SceneModel {
  private static final int MOST_TASKS = 1000;
  private static final int MOST_FRAMES = 1000;

  private final Input<Data> input;
  private final Frames known;
  private final SettingsStore settings;
  private final RobotClock clock;
  private final Supplier<List<DisplayType>> kinds;
  private final DisplayContext context;
  private final Waypoints waypoints;
  private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
  private final Map<String, DisplaySlot> slots = new LinkedHashMap<>();
  private final RobotColors colors;
  private final Set<FrameId> named = new LinkedHashSet<>();
  private Set<SourceId> chosen = Set.of();
  /** What is said once, for displays that come later. */
  private final Map<SourceId, Envelope<Data>> descriptions = new HashMap<>();
  private long epoch;
  private final PastLook past;
  private List<Part> marks = List.of();
  private List<Part> then = List.of();
  private volatile Stage stage = Stage.NONE;

  /** A scene of a view. */
  public SceneModel(UicContext context, Supplier<List<DisplayType>> kinds, DisplayContext displays,
      Waypoints waypoints) {
    input = context.input(ScenePorts.DATA);
    known = context.frames();
    settings = context.settings();
    clock = context.clock();
    epoch = clock.epoch();
    colors = new RobotColors(context.ruic().authorities().stream().map(Authority::robot).distinct().toList());
    this.kinds = kinds;
    this.context = displays;
    this.waypoints = waypoints;
    past = new PastLook(context);
  }

  /** What the last tick made; any thread. */
  public Stage stage() {
    return stage;
  }

  /** Runs something on the worker with the next tick; any thread. */
  public void soon(Runnable task) {
    if (tasks.size() < MOST_TASKS) {
      tasks.add(task);
    }
  }

  /** The displays that are listed, as they would be written; any thread. */
  public List<DisplaySpec> specs() {
    Settings now = settings.current();
    List<DisplaySpec> written = DisplayCodec.read(now, SceneOptions.DISPLAYS);
    return written.isEmpty() && now.flag(SceneOptions.AUTOMATIC)
        ? Automatic.displays(Kinds.of(kinds.get()), input.candidates())
        : written;
  }

  /** A kind of display that takes a stream. Any thread. */
  public Optional<DisplayType> kindFor(SourceId port) {
    List<Input.Candidate> offered = input.candidates();
    return kinds.get().stream()
        .filter(kind -> kind.accepts().stream().anyMatch(data -> SourceChoice.fitting(data, offered).contains(port)))
        .findFirst();
  }

  /** Prepares; true where there is something new to show. */
  public boolean tick(long nowNanos) {
    Settings now = settings.current();
    Frames frames = new JoinedFrames(known, Joint.read(now));
    configure();
    boolean reset = clock.epoch() != epoch;
    if (reset) {
      epoch = clock.epoch();
      input.recall(); // what displays forget now and the robot says but once
    }
    drain();
    Optional<String> wanted = Optional.of(now.text(SceneOptions.FIXED_FRAME).strip())
        .filter(f -> !f.isEmpty() && !f.equals(SceneOptions.AUTO));
    Optional<FrameId> fixed = FixedFrame.choose(wanted.map(SceneModel::plain), frames, List.copyOf(named));
    ScenePlaces places = new ScenePlaces(frames, fixed.orElse(new FrameId("scene", "fixed")));
    boolean changed = runTasks();
    changed |= update(places, now, nowNanos, reset);
    List<Part> before = marks;
    marks = waypoints.tick(places);
    changed |= !PartsCheck.same(before, marks);
    List<Part> pointed = then;
    then = past.parts(places, robot -> colors.of(robot, now));
    changed |= !PartsCheck.same(pointed, then);
    List<Stage.Robot> robots = Robots.find(places, named, r -> colors.of(r, now));
    return show(fixed, frames(places), robots, changed);
  }

  /** Those that can be chosen: also what only data name, in which they can be shown without any transform. */
  private List<FrameId> frames(ScenePlaces places) {
    List<FrameId> known = places.all();
    return named.isEmpty() || known.containsAll(named) ? known
        : Stream.concat(known.stream(), named.stream()).distinct()
            .sorted(Comparator.comparing(FrameId::robot).thenComparing(FrameId::name)).toList();
  }

  /** Nobody looks: gives up what it holds, and asks the robot for nothing. */
  public void rest() {
    if (!slots.isEmpty()) {
      slots.values().forEach(DisplaySlot::end);
      slots.clear();
      choose(Set.of());
      input.drain(e -> {});
      stage = new Stage(stage.version() + 1, Map.of(), stage.rows(), stage.fixed(), stage.frames(), stage.robots(),
          stage.dropped());
    }
    tasks.clear();
  }

  private void configure() {
    Map<String, DisplayType> byId =
        kinds.get().stream().collect(Collectors.toMap(DisplayType::id, Function.identity(), (a, b) -> a));
    List<Input.Candidate> offered = input.candidates();
    Map<String, DisplaySlot> before = new HashMap<>(slots);
    slots.clear();
    for (DisplaySpec spec : specs()) {
      DisplaySlot slot = Optional.ofNullable(before.remove(spec.id())).filter(s -> s.spec().type().equals(spec.type()))
          .orElseGet(() -> new DisplaySlot(spec));
      Set<SourceId> had = slot.choice().sources();
      slot.configure(spec, Optional.ofNullable(byId.get(spec.type())), offered);
      slot.choice().sources().stream().filter(source -> !had.contains(source) && descriptions.containsKey(source))
          .forEach(source -> slot.take(descriptions.get(source)));
      slots.put(spec.id(), slot);
    }
    before.values().forEach(DisplaySlot::end);
    choose(slots.values().stream().filter(DisplaySlot::wanted).flatMap(s -> s.taken().stream())
        .collect(Collectors.toSet()));
  }

  private void choose(Set<SourceId> sources) {
    if (!sources.equals(chosen)) {
      chosen = Set.copyOf(sources);
      descriptions.keySet().retainAll(chosen);
      input.choose(chosen);
    }
  }

  private void drain() {
    input.drain(envelope -> {
      if (envelope.value() instanceof RobotDescription) {
        descriptions.put(envelope.source(), envelope);
      }
      if (envelope.value() instanceof Framed framed) {
        framed.frames().limit(MOST_FRAMES).filter(f -> named.size() < MOST_FRAMES).forEach(named::add);
      }
      slots.values().stream().filter(s -> s.wanted() && s.taken().contains(envelope.source()))
          .forEach(s -> s.take(envelope));
    });
  }

  private boolean runTasks() {
    boolean some = false;
    for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
      task.run();
      some = true;
    }
    return some;
  }

  private boolean update(ScenePlaces places, Settings now, long nowNanos, boolean reset) {
    boolean changed = false;
    for (DisplaySlot slot : slots.values()) {
      String robot = slot.robot().orElseGet(() -> places.fixed().robot());
      changed |= slot.update(context, input,
          new SlotTick(places, colors.of(robot, now), nowNanos, reset,
              received -> clock.ageSeconds(received, nowNanos)));
    }
    return changed;
  }

  private boolean show(Optional<FrameId> fixed, List<FrameId> frames, List<Stage.Robot> robots, boolean changed) {
    Map<Object, List<Part>> parts = new LinkedHashMap<>();
    slots.forEach((id, slot) -> {
      if (!slot.result().parts().isEmpty()) {
        parts.put(id, slot.result().parts());
      }
    });
    if (!marks.isEmpty()) {
      parts.put(Waypoints.DISPLAY, marks);
    }
    if (!then.isEmpty()) {
      parts.put(PastLook.DISPLAY, then);
    }
    boolean other = changed || !parts.keySet().equals(stage.parts().keySet());
    List<DisplayRow> rows = new ArrayList<>();
    slots.values().forEach(s -> rows.add(s.row()));
    long dropped = input.dropped() + rows.stream().mapToLong(DisplayRow::dropped).sum();
    Stage before = stage;
    stage = new Stage(other ? before.version() + 1 : before.version(), parts, List.copyOf(rows), fixed, frames, robots,
        dropped, slots.values().stream().flatMap(slot -> slot.colors().stream()).toList());
    return other || !rows.equals(before.rows()) || !fixed.equals(before.fixed()) || !robots.equals(before.robots())
        || dropped != before.dropped() || !stage.colors().equals(before.colors());
  }

  /** Frames are also written robot/frame. */
  private static String plain(String written) {
    return written.indexOf(':') > 0 ? written : Joint.frame(written).map(FrameId::toString).orElse(written);
  }
}
