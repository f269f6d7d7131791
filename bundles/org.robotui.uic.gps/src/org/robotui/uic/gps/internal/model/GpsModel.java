package org.robotui.uic.gps.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import org.robotui.api.UicContext;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RobotClock;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.GpsFix;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.entity.gps.LocalPlane;
import org.robotui.ui.StateView;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.layer.EarthOrigin;
import org.robotui.ui.layer.LayerInputs;
import org.robotui.ui.layer.LayerStack;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.scene.Scene;
import org.robotui.uic.gps.internal.GpsOptions;
import org.robotui.uic.gps.internal.GpsType;

/**
 * Takes the newest fixes, puts them on the plane and prepares the layers. Worker thread, but for what says otherwise.
 */
public final class GpsModel {
  private final Input<GpsFix> input;
  private final RobotClock clock;
  private final Scene scene = new Scene();
  private final Map<SourceId, Source> sources = new LinkedHashMap<>();
  private final LayerStack layers;
  private final AtomicBoolean forget = new AtomicBoolean();
  private Optional<GeoPoint> firstFix = Optional.empty();
  private volatile GpsOptions inForce;
  private long epoch;
  private int traces;
  private volatile GpsSnapshot snapshot = GpsSnapshot.NONE;

  /** A receiver and what is known of it. */
  private static final class Source {
    final int trace;
    Optional<Envelope<GpsFix>> shown = Optional.empty();
    Optional<GeoPoint> place = Optional.empty();

    Source(int trace) {
      this.trace = trace;
    }
  }

  /** A view of what bundles bring layers for. */
  public GpsModel(UicContext context, Supplier<List<LayerType>> kinds) {
    input = context.input(GpsType.FIX);
    clock = context.clock();
    epoch = clock.epoch();
    inForce = GpsOptions.of(context.settings().current());
    layers = new LayerStack(LayerType.Ground.EARTH, scene, context,
        new LayerInputs(context, List.of(GpsType.FIX), GpsType.DATA), kinds, new Rules());
  }

  /** What the older settings of the view, and its receivers, say of layers. */
  private final class Rules implements LayerStack.Rules {
    @Override
    public DisplaySpec begin(DisplaySpec spec) {
      return inForce.begin(spec);
    }

    @Override
    public Optional<String> name(SourceId source) {
      return Optional.ofNullable(sources.get(source)).flatMap(s -> s.shown)
          .map(e -> GpsModel.this.name(source, e.value().frame()));
    }

    @Override
    public OptionalInt trace(SourceId source) {
      return Optional.ofNullable(sources.get(source)).map(s -> OptionalInt.of(s.trace)).orElse(OptionalInt.empty());
    }
  }

  /** Prepares; true where there is something new to show. */
  public boolean tick(long nowNanos, GpsOptions options) {
    boolean reset = forgetWhereDue();
    boolean changed = reset | !inForce.equals(options);
    inForce = options;
    changed |= removeOthers(input.sources());
    changed |= takeNew();
    Optional<LocalPlane> plane = options.origin().or(() -> firstFix).map(LocalPlane::new);
    layers.take(reset);
    changed |= layers.prepare(Optional.empty(),
        plane.map(p -> new EarthOrigin(p.origin().latitude(), p.origin().longitude())), List.of(), nowNanos, reset);
    GpsSnapshot next = new GpsSnapshot(state(), plane, receivers(plane));
    changed |= !plane.equals(snapshot.plane()) | !words(next).equals(words(snapshot));
    snapshot = next;
    return changed;
  }

  /** What is listed. */
  public LayerStack layers() {
    return layers;
  }

  /** What the last tick found; any thread. */
  public GpsSnapshot snapshot() {
    return snapshot;
  }

  /** The layers; any thread. */
  public Scene scene() {
    return scene;
  }

  /** Has the ways, and the first fix as origin, forgotten with the next tick. Any thread. */
  public void clear() {
    forget.set(true);
  }

  private boolean forgetWhereDue() {
    boolean jumped = clock.epoch() != epoch;
    epoch = clock.epoch();
    boolean due = forget.getAndSet(false) || jumped;
    if (due) {
      firstFix = sources.values().stream().flatMap(s -> s.place.stream()).findFirst();
    }
    return due;
  }

  private boolean removeOthers(List<SourceId> connected) {
    List<SourceId> gone = sources.keySet().stream().filter(id -> !connected.contains(id)).toList();
    gone.forEach(sources::remove);
    return !gone.isEmpty();
  }

  private boolean takeNew() {
    boolean fresh = false;
    for (SourceId id : input.sources()) {
      Optional<Envelope<GpsFix>> latest = input.latest(id);
      fresh |= latest.isPresent() && take(id, latest.get());
    }
    return fresh;
  }

  private boolean take(SourceId id, Envelope<GpsFix> latest) {
    Source source = sources.computeIfAbsent(id, n -> new Source(traces++));
    boolean isNew = source.shown.filter(e -> e.value() == latest.value()).isEmpty();
    if (isNew) {
      source.shown = Optional.of(latest);
      Optional<GeoPoint> place = GeoPoint.of(latest.value());
      source.place = place.or(() -> source.place);
      firstFix = firstFix.or(() -> place);
    }
    return isNew;
  }

  private List<Receiver> receivers(Optional<LocalPlane> plane) {
    List<Receiver> receivers = new ArrayList<>();
    sources.forEach((id, s) -> s.shown
        .ifPresent(e -> receivers.add(new Receiver(id, name(id, e.value().frame()), s.trace, e.value(),
            s.place, plane.flatMap(p -> s.place.flatMap(p::point)), input.state(id)))));
    return List.copyOf(receivers);
  }

  /** The robot, and which of its receivers where it has several. */
  private String name(SourceId id, FrameId frame) {
    List<FrameId> frames =
        sources.values().stream().flatMap(s -> s.shown.stream()).map(e -> e.value().frame()).toList();
    if (frames.stream().filter(f -> f.robot().equals(frame.robot())).count() < 2) {
      return frame.robot();
    }
    boolean told = !frame.name().isEmpty() && frames.stream().filter(frame::equals).count() == 1;
    return frame.robot() + " " + (told ? frame.name() : id.port());
  }

  private InputState state() {
    return WholeState.of(input.sources().stream().map(input::state).toList(), input.state());
  }

  /** What of a snapshot users can read, ages of live data left aside. */
  private static List<String> words(GpsSnapshot snapshot) {
    List<String> words = new ArrayList<>();
    words.add(StateView.word(snapshot.state()) + snapshot.state().explanation());
    snapshot.receivers().forEach(r -> words.add(r.name() + StateView.word(r.state())));
    return words;
  }
}
