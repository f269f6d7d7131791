package org.robotui.entity.marker.internal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.marker.InteractiveMarker;
import org.robotui.data.marker.InteractiveMarker.Control;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.data.marker.MarkerFeedback;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.display.Recent;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Rgba;

/** The interactive markers of some sources. */
final class InteractiveDisplay implements Display {
  static final int MOST = 2_000;
  private static final float LETTERS = 14;
  /** Above the usual arrows, in sizes of the marker. */
  private static final double ABOVE = 1.05;
  /** Read on dark and on light. */
  private static final Rgba LETTERING = Rgba.of(0x8b98a8);

  private record Id(SourceId source, String name) {}

  private record Key(Id id, int control, int piece) {}

  private final DisplayContext context;
  private final String client = UUID.randomUUID().toString().substring(0, 8);
  private final Map<Id, Movable> markers = new LinkedHashMap<>();
  private final Map<Id, Label> labels = new LinkedHashMap<>();
  private String refusal = "";
  private long dropped;

  InteractiveDisplay(DisplayContext context) {
    this.context = context;
  }

  @Override
  public DisplayResult update(DisplayTick tick) {
    if (tick.reset() || tick.state() instanceof InputState.Unconnected) {
      close();
    }
    for (Envelope<? extends Data> envelope : tick.arrived()) {
      if (envelope.value() instanceof InteractiveMarkerSet set) {
        take(envelope.source(), set);
      }
    }
    List<Part> parts = new ArrayList<>();
    List<String> missing = new ArrayList<>();
    markers.forEach((id, marker) -> show(id, marker, tick, parts, missing));
    return new DisplayResult(parts, status(tick, missing), dropped);
  }

  private void take(SourceId source, InteractiveMarkerSet set) {
    if (set.all()) {
      markers.keySet().removeIf(
          id -> id.source().equals(source) && set.entries().stream().noneMatch(e -> e.name().equals(id.name())));
    }
    for (InteractiveMarkerSet.Entry entry : set.entries()) {
      Id id = new Id(source, entry.name());
      entry.marker().ifPresentOrElse(marker -> put(id, marker), () -> markers.remove(id));
    }
    labels.keySet().retainAll(markers.keySet());
  }

  private void put(Id id, InteractiveMarker marker) {
    Movable known = markers.get(id);
    if (known != null) {
      known.take(marker);
    } else if (markers.size() < MOST) {
      markers.put(id, new Movable(marker, client, this::send));
    } else {
      dropped++;
    }
  }

  private boolean send(MarkerFeedback feedback) {
    CommandOutcome outcome = context.send(feedback);
    refusal = outcome instanceof CommandOutcome.Refused refused ? refused.explanation() : "";
    context.wake();
    return refusal.isEmpty();
  }

  private void show(Id id, Movable movable, DisplayTick tick, List<Part> parts, List<String> missing) {
    InteractiveMarker marker = movable.marker();
    Places.Place place = tick.places().at(marker.frame(), marker.stamp());
    if (place.found().isEmpty() && marker.stamp().isPresent()) {
      place = tick.places().at(marker.frame(), Optional.empty());
    }
    movable.tick(place.found(), tick.nowNanos());
    if (place instanceof Places.Place.Missing lost) {
      missing.add(lost.reason());
    }
    Optional<RigidTransform> frame = place.found().filter(f -> !movable.flawed());
    frame.ifPresent(f -> {
      controls(id, movable, f, tick, parts);
      if (tick.settings().flag(InteractiveType.DESCRIPTIONS) && !marker.description().isBlank()) {
        parts.add(label(id, movable, f));
      }
    });
  }

  private static void controls(Id id, Movable movable, RigidTransform frame, DisplayTick tick, List<Part> parts) {
    List<Control> controls = movable.marker().controls();
    for (int c = 0; c < controls.size(); c++) {
      Control control = controls.get(c);
      List<ControlLook.Piece> pieces = movable.looks().get(c);
      RigidTransform base = frame.times(movable.base(control));
      for (int p = 0; p < pieces.size(); p++) {
        Key key = new Key(id, c, p);
        ControlLook.Piece piece = pieces.get(p);
        Optional<RigidTransform> at = piece.frame().isEmpty() ? Optional.of(base)
            : tick.places().at(piece.frame().get(), Optional.empty()).found();
        at.ifPresent(a -> parts.add(part(key, movable, control, piece, a, Recent.paleness(tick))));
      }
    }
  }

  private static Part part(Key key, Movable movable, Control control, ControlLook.Piece piece, RigidTransform base,
      float pale) {
    boolean handled = control.mode() != InteractiveMarker.Mode.NONE || !movable.marker().menu().isEmpty();
    String title = movable.marker().name() + (control.description().isEmpty() ? "" : ": " + control.description());
    return new Part(key, piece.shape(), base.times(piece.at()), piece.material().paled(pale), Describer.of(title),
        handled ? Optional.of(movable.handle(control)) : Optional.empty());
  }

  private Part label(Id id, Movable movable, RigidTransform frame) {
    String text = movable.marker().description();
    Label label = Optional.ofNullable(labels.get(id)).filter(l -> l.text().equals(text))
        .orElseGet(() -> new Label(text, LETTERS, PointSet.Unit.PIXELS));
    labels.put(id, label);
    Vector3 above = frame.apply(movable.pose().translation())
        .plus(new Vector3(0, 0, ABOVE * Math.max(0, movable.marker().scale())));
    return new Part(new Key(id, -1, 0), label, new RigidTransform(above, Quaternion.IDENTITY), Material.flat(LETTERING),
        Describer.of(text));
  }

  private DisplayStatus status(DisplayTick tick, List<String> missing) {
    if (markers.isEmpty()) {
      boolean live = tick.state() instanceof InputState.Live;
      // Who says so may have some again at any time: nothing is missing.
      return live ? new DisplayStatus.Shown("there are no interactive markers now")
          : new DisplayStatus.NoData(tick.state().explanation());
    }
    if (!missing.isEmpty()) {
      return new DisplayStatus.NoFrame(missing.getFirst());
    }
    Optional<String> flawed = markers.values().stream().filter(Movable::flawed).findFirst()
        .map(m -> "the pose of " + m.marker().name() + " is not finite");
    Optional<String> trouble =
        Optional.of(refusal).filter(r -> !r.isEmpty()).map(r -> "not told to the robot: " + r).or(() -> flawed);
    if (dropped > 0) {
      trouble = trouble
          .or(() -> Optional.of("there are more than " + MOST + " interactive markers; the others are left out"));
    }
    int count = markers.size();
    return trouble.<DisplayStatus>map(DisplayStatus.Partly::new)
        .orElse(new DisplayStatus.Shown(count + (count == 1 ? " interactive marker" : " interactive markers")));
  }

  @Override
  public void close() {
    markers.clear();
    labels.clear();
  }
}
