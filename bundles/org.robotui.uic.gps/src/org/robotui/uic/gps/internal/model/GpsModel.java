package org.robotui.uic.gps.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.UicContext;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.RobotClock;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.GpsFix;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.entity.gps.GpsEntity;
import org.robotui.entity.gps.LocalPlane;
import org.robotui.entity.grid.GridEntity;
import org.robotui.ui.StateView;
import org.robotui.ui.scene.Layer;
import org.robotui.ui.scene.Scene;
import org.robotui.uic.gps.internal.GpsOptions;
import org.robotui.uic.gps.internal.GpsType;

/**
 * Takes the newest fixes, puts them on the plane and prepares the layers. Worker thread, but for what says otherwise.
 */
public final class GpsModel {
  private static final String GRID = "grid";
  private static final String RECEIVER = "receiver:";

  private final Input<GpsFix> input;
  private final RobotClock clock;
  private final Scene scene = new Scene();
  private final Map<SourceId, Source> sources = new LinkedHashMap<>();
  private final AtomicBoolean forget = new AtomicBoolean();
  private Optional<GeoPoint> firstFix = Optional.empty();
  private Optional<GpsOptions> inForce = Optional.empty();
  private long epoch;
  private int traces;
  private volatile GpsSnapshot snapshot = GpsSnapshot.NONE;

  /** A receiver and what is known of it. */
  private static final class Source {
    final int trace;
    final GpsEntity entity;
    final Layer layer;
    Optional<Envelope<GpsFix>> shown = Optional.empty();
    Optional<GeoPoint> place = Optional.empty();

    Source(SourceId id, int trace) {
      this.trace = trace;
      this.entity = new GpsEntity(trace);
      this.layer = new Layer(RECEIVER + id, 1 + trace, id.toString(), entity);
    }
  }

  public GpsModel(UicContext context) {
    input = context.input(GpsType.FIX);
    clock = context.clock();
    epoch = clock.epoch();
    scene.add(new Layer(GRID, 0, "Grid", new GridEntity()));
  }

  /** Prepares; true where there is something new to show. */
  public boolean tick(long nowNanos, GpsOptions options) {
    boolean changed = forgetWhereDue() | !inForce.equals(Optional.of(options));
    inForce = Optional.of(options);
    changed |= removeOthers(input.sources());
    List<SourceId> fresh = takeNew();
    Optional<LocalPlane> plane = options.origin().or(() -> firstFix).map(LocalPlane::new);
    boolean moved = !plane.equals(snapshot.plane());
    plane.ifPresent(p -> sources.forEach((id, source) -> {
      if (moved || fresh.contains(id)) {
        source.shown.ifPresent(e -> source.entity.prepare(e.value(), p, e.receivedNanos(), options.trailNanos()));
      }
    }));
    GpsSnapshot next = new GpsSnapshot(state(), plane, receivers(plane));
    changed |= configure(next, options) | moved | !fresh.isEmpty() | !words(next).equals(words(snapshot));
    snapshot = next;
    return changed;
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
      sources.values().forEach(s -> s.entity.clear());
      firstFix = sources.values().stream().flatMap(s -> s.place.stream()).findFirst();
    }
    return due;
  }

  private boolean removeOthers(List<SourceId> connected) {
    List<SourceId> gone = sources.keySet().stream().filter(id -> !connected.contains(id)).toList();
    gone.forEach(id -> scene.remove(sources.remove(id).layer.id()));
    return !gone.isEmpty();
  }

  private List<SourceId> takeNew() {
    List<SourceId> fresh = new ArrayList<>();
    for (SourceId id : input.sources()) {
      Optional<Envelope<GpsFix>> latest = input.latest(id);
      if (latest.isPresent() && take(id, latest.get())) {
        fresh.add(id);
      }
    }
    return fresh;
  }

  private boolean take(SourceId id, Envelope<GpsFix> latest) {
    Source source = sources.computeIfAbsent(id, this::add);
    boolean isNew = source.shown.filter(e -> e.value() == latest.value()).isEmpty();
    if (isNew) {
      source.shown = Optional.of(latest);
      Optional<GeoPoint> place = GeoPoint.of(latest.value());
      source.place = place.or(() -> source.place);
      firstFix = firstFix.or(() -> place);
    }
    return isNew;
  }

  private Source add(SourceId id) {
    Source source = new Source(id, traces++);
    scene.add(source.layer);
    return source;
  }

  private boolean configure(GpsSnapshot now, GpsOptions options) {
    boolean several = now.receivers().size() > 1;
    boolean byQuality = options.ways() == GpsOptions.Ways.QUALITY || options.ways() == GpsOptions.Ways.AUTO && !several;
    scene.find(GRID).ifPresent(l -> l.show(options.grid()));
    boolean changed = false;
    for (Receiver receiver : now.receivers()) {
      Source source = sources.get(receiver.id());
      boolean stale = receiver.state() instanceof InputState.Stale;
      changed |= source.layer.faded() != stale;
      source.layer.fade(stale);
      source.entity.colorByQuality(byQuality);
      source.entity.label(several ? Optional.of(receiver.name()) : Optional.empty());
    }
    return changed;
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
