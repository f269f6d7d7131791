package org.robotui.uic.scene3d.internal.model;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.api.frame.FrameLink;
import org.robotui.api.frame.FrameRefusal;
import org.robotui.api.frame.Frames;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformLookup;

/** The frames of several robots, joined where the configuration says how they stand to one another. */
public final class JoinedFrames implements Frames {
  private final Frames known;
  private final List<Joint> joints;

  /** Joins. */
  public JoinedFrames(Frames known, List<Joint> joints) {
    this.known = known;
    this.joints = List.copyOf(joints);
  }

  @Override
  public TransformLookup<FrameId> lookup(FrameId target, FrameId source, Optional<Stamp> stamp) {
    TransformLookup<FrameId> direct = known.lookup(target, source, stamp);
    boolean apart = direct instanceof TransformLookup.Disconnected || direct instanceof TransformLookup.UnknownFrame;
    if (joints.isEmpty() || !apart) {
      return direct;
    }
    return over(target, source, stamp)
        .<TransformLookup<FrameId>>map(t -> new TransformLookup.Found<>(t, stamp.map(Stamp::nanos).orElse(0L)))
        .orElse(direct);
  }

  /** A place on the way: where the source is in a frame that was reached. */
  private record Reached(FrameId frame, RigidTransform frameFromSource) {}

  private Optional<RigidTransform> over(FrameId target, FrameId source, Optional<Stamp> stamp) {
    Deque<Reached> open = new ArrayDeque<>(List.of(new Reached(source, RigidTransform.IDENTITY)));
    Set<FrameId> seen = new HashSet<>(Set.of(source));
    while (!open.isEmpty()) {
      Reached at = open.poll();
      Optional<RigidTransform> there = plain(target, at.frame(), stamp);
      if (there.isPresent()) {
        return there.map(t -> t.times(at.frameFromSource()));
      }
      steps(at, stamp).stream().filter(step -> seen.add(step.frame())).forEach(open::add);
    }
    return Optional.empty();
  }

  private List<Reached> steps(Reached at, Optional<Stamp> stamp) {
    List<Reached> steps = new ArrayList<>();
    for (Joint joint : joints) {
      plain(joint.child(), at.frame(), stamp).ifPresent(
          t -> steps.add(new Reached(joint.parent(), joint.parentFromChild().times(t).times(at.frameFromSource()))));
      plain(joint.parent(), at.frame(), stamp).ifPresent(t -> steps
          .add(new Reached(joint.child(), joint.parentFromChild().inverse().times(t).times(at.frameFromSource()))));
    }
    return steps;
  }

  private Optional<RigidTransform> plain(FrameId target, FrameId source, Optional<Stamp> stamp) {
    return target.equals(source) ? Optional.of(RigidTransform.IDENTITY)
        : known.lookup(target, source, stamp).transform();
  }

  @Override
  public List<FrameId> all() {
    List<FrameId> plain = known.all();
    if (joints.isEmpty()) {
      return plain;
    }
    return Stream.concat(plain.stream(), joints.stream().flatMap(j -> Stream.of(j.parent(), j.child()))).distinct()
        .sorted(Comparator.comparing(FrameId::robot).thenComparing(FrameId::name)).toList();
  }

  @Override
  public Optional<FrameId> parent(FrameId frame) {
    return known.parent(frame)
        .or(() -> joints.stream().filter(j -> j.child().equals(frame)).map(Joint::parent).findFirst());
  }

  @Override
  public List<FrameLink> links() {
    return known.links();
  }

  @Override
  public List<FrameRefusal> refusals() {
    return known.refusals();
  }
}
