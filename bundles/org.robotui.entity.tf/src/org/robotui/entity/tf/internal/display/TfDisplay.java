package org.robotui.entity.tf.internal.display;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Settings;
import org.robotui.data.FrameId;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.ColorSetting;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.display.DisplayTick;
import org.robotui.gl.display.Places;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Rgba;

/**
 * The frames of all robots of a scene. All axes are one shape, made again only where one moved; at most {@link #MOST}
 * frames, fewer names.
 */
final class TfDisplay implements Display {
  /** Frames that are shown at most. */
  static final int MOST = 2000;

  /** Names that are shown at most. */
  static final int MOST_NAMES = 300;

  private static final float NAME_PIXELS = 12;
  private static final float LINE_PIXELS = 1.5f;
  private static final double ABOVE = 1.08;
  private static final int NAMED = 3;

  private final Map<FrameId, Label> names = new HashMap<>();
  private Map<FrameId, RigidTransform> placed = Map.of();
  private double size;
  private Optional<Instances> axes = Optional.empty();
  private Optional<LineSet> links = Optional.empty();
  private List<FrameId> parents = List.of();

  @Override
  public DisplayResult update(DisplayTick tick) {
    Settings settings = tick.settings();
    FrameFilter filter = new FrameFilter(settings.list(TfType.FRAMES), settings.list(TfType.HIDDEN));
    List<FrameId> all = tick.places().all();
    List<FrameId> wanted = all.stream().filter(filter::admits).limit(MOST + 1L).toList();
    Map<FrameId, RigidTransform> at = new LinkedHashMap<>();
    List<String> missing = new ArrayList<>();
    for (FrameId frame : wanted.subList(0, Math.min(MOST, wanted.size()))) {
      switch (tick.places().at(frame, Optional.empty())) {
        case Places.Place.At found -> at.put(frame, found.fixedFromFrame());
        case Places.Place.Missing none -> missing.add(none.reason());
      }
    }
    shapes(at, tick.places(), settings.number(TfType.SIZE));
    return new DisplayResult(parts(at, settings), status(tick, all.size(), wanted.size(), missing), 0);
  }

  private void shapes(Map<FrameId, RigidTransform> at, Places places, double length) {
    List<FrameId> nextParents =
        at.keySet().stream().map(frame -> places.parent(frame).filter(at::containsKey).orElse(frame)).toList();
    if (at.equals(placed) && length == size && nextParents.equals(parents)) {
      return;
    }
    placed = at;
    size = length;
    parents = nextParents;
    Placings placings = new Placings(Math.max(1, at.size()));
    at.values().forEach(place -> placings.add(place, new Vector3(length, length, length)));
    axes = at.isEmpty() ? Optional.empty() : Optional.of(placings.of(Meshes.axes()));
    links = lines(at);
    names.keySet().retainAll(at.keySet());
  }

  private Optional<LineSet> lines(Map<FrameId, RigidTransform> at) {
    float[] xyz = new float[6 * at.size()];
    int end = 0;
    int i = 0;
    for (Map.Entry<FrameId, RigidTransform> entry : at.entrySet()) {
      FrameId parent = parents.get(i++);
      Vector3 from = entry.getValue().translation();
      Vector3 to = at.get(parent).translation();
      if (!parent.equals(entry.getKey()) && from.minus(to).norm() > 0) {
        end = put(xyz, put(xyz, end, from), to);
      }
    }
    return end == 0 ? Optional.empty()
        : Optional.of(LineSet.of(LineSet.Kind.SEGMENTS, LINE_PIXELS, Arrays.copyOf(xyz, end)));
  }

  private static int put(float[] xyz, int at, Vector3 point) {
    xyz[at] = (float) point.x();
    xyz[at + 1] = (float) point.y();
    xyz[at + 2] = (float) point.z();
    return at + 3;
  }

  private List<Part> parts(Map<FrameId, RigidTransform> at, Settings settings) {
    List<Part> parts = new ArrayList<>();
    List<FrameId> order = List.copyOf(at.keySet());
    axes.ifPresent(shape -> parts
        .add(new Part("axes", shape, RigidTransform.IDENTITY, Material.lit(Rgba.WHITE), describer(order))));
    if (settings.flag(TfType.LINKS)) {
      links.ifPresent(shape -> parts.add(new Part("links", shape, RigidTransform.IDENTITY,
          Material.flat(ColorSetting.read(settings, TfType.LINK_COLOR)), Describer.of("Lines to parent frames"))));
    }
    if (settings.flag(TfType.NAMES)) {
      Material color = Material.flat(ColorSetting.read(settings, TfType.NAME_COLOR)).onTop();
      order.stream().limit(MOST_NAMES).forEach(
          frame -> parts.add(new Part(frame, name(frame), above(at.get(frame)), color, describer(List.of(frame)))));
    }
    return parts;
  }

  private Label name(FrameId frame) {
    return names.computeIfAbsent(frame, f -> new Label(f.name(), NAME_PIXELS, PointSet.Unit.PIXELS));
  }

  private RigidTransform above(RigidTransform place) {
    return new RigidTransform(place.translation().plus(new Vector3(0, 0, ABOVE * size)), Quaternion.IDENTITY);
  }

  private Describer describer(List<FrameId> order) {
    Map<FrameId, RigidTransform> at = placed;
    List<FrameId> carriers = parents;
    List<FrameId> all = List.copyOf(at.keySet());
    return (element, place) -> {
      FrameId frame = order.get(Math.min(element, order.size() - 1));
      return FrameWords.of(frame, carriers.get(all.indexOf(frame)), at.get(frame));
    };
  }

  private static DisplayStatus status(DisplayTick tick, int all, int wanted, List<String> missing) {
    if (all == 0) {
      return new DisplayStatus.NoData("no robot of this scene has sent a transform yet");
    }
    if (wanted == 0) {
      return new DisplayStatus.NoData("none of the " + all + " frames is chosen: look at frames and hidden_frames");
    }
    if (missing.size() >= wanted) {
      return new DisplayStatus.NoFrame(missing.getFirst());
    }
    Optional<String> wrong = ColorSetting.complaint(tick.settings());
    if (!missing.isEmpty()) {
      return new DisplayStatus.Partly(
          missing.size() + " of " + wanted + " frames are not linked with " + tick.places().fixed() + ": "
              + String.join("; ", missing.subList(0, Math.min(NAMED, missing.size()))));
    }
    if (wanted > MOST) {
      return new DisplayStatus.Partly("there are more than " + MOST + " frames; the others are left out");
    }
    return wrong.<DisplayStatus>map(DisplayStatus.Partly::new)
        .orElseGet(() -> new DisplayStatus.Shown(words(tick, all, wanted)));
  }

  private static String words(DisplayTick tick, int all, int wanted) {
    boolean cut = tick.settings().flag(TfType.NAMES) && wanted > MOST_NAMES;
    return wanted + (wanted == 1 ? " frame" : " frames") + (wanted < all ? " of " + all : "")
        + (cut ? ", names of " + MOST_NAMES : "");
  }

  @Override
  public void close() {
    names.clear();
    axes = Optional.empty();
    links = Optional.empty();
    placed = Map.of();
  }
}
