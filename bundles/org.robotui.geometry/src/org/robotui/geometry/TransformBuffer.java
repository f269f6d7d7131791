package org.robotui.geometry;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * The transforms between the frames of a robot over time: a tree whose edges are sampled, or static. Between samples it
 * interpolates; it never extrapolates. A frame has one parent: a transform from another parent moves it there and
 * forgets its history. Safe for use by several threads.
 *
 * @param <F> names a frame, by {@link Object#equals}; its text is shown to users
 */
public final class TransformBuffer<F> {
  /** How far the length of a rotation may be from 1; within, it is scaled to 1. ROS's own buffer takes the same. */
  private static final double LENGTH_TOLERANCE = 0.01;
  private static final double FARTHEST = 1e9;

  private final TransformLimits limits;
  private final Map<F, TransformHistory<F>> byChild = new HashMap<>();

  /** Creates an empty buffer with {@link TransformLimits#DEFAULT}. */
  public TransformBuffer() {
    this(TransformLimits.DEFAULT);
  }

  /**
   * Creates an empty buffer.
   *
   * @param limits how much it holds
   */
  public TransformBuffer(TransformLimits limits) {
    this.limits = Objects.requireNonNull(limits, "limits");
  }

  /**
   * Stores where a child frame is at a time.
   *
   * @param parent the parent frame
   * @param child the child frame
   * @param stampNanos the time, nanoseconds of the sender's clock, not negative
   * @param parentFromChild the transform; its rotation is scaled to unit length
   * @param authority who says so
   * @return whether it was stored
   */
  public TransformPut<F> put(
      F parent, F child, long stampNanos, RigidTransform parentFromChild, String authority) {
    return store(new TransformHistory<>(parent, child, false), child, stampNanos, parentFromChild, authority);
  }

  /**
   * Stores where a child frame always is.
   *
   * @param parent the parent frame
   * @param child the child frame
   * @param parentFromChild the transform; its rotation is scaled to unit length
   * @param authority who says so
   * @return whether it was stored
   */
  public TransformPut<F> putStatic(F parent, F child, RigidTransform parentFromChild, String authority) {
    return store(new TransformHistory<>(parent, child, true), child, 0, parentFromChild, authority);
  }

  private TransformPut<F> store(
      TransformHistory<F> fresh, F child, long stamp, RigidTransform transform, String authority) {
    Optional<String> malformed = stamp < 0 ? Optional.of("has a negative stamp") : malformed(transform);
    if (malformed.isPresent()) {
      return new TransformPut.Refused<>(name(fresh.parent(), child) + " " + malformed.get());
    }
    RigidTransform clean = new RigidTransform(transform.translation(), transform.rotation().normalized());
    synchronized (byChild) {
      Optional<String> misplaced = misplaced(fresh.parent(), child);
      return misplaced.isPresent()
          ? new TransformPut.Refused<>(name(fresh.parent(), child) + " " + misplaced.get())
          : insert(fresh, child, stamp, clean, authority);
    }
  }

  private TransformPut<F> insert(
      TransformHistory<F> fresh, F child, long stamp, RigidTransform transform, String authority) {
    TransformHistory<F> known = byChild.get(child);
    boolean moved = known != null && !known.parent().equals(fresh.parent());
    boolean goesOn = known != null && !moved && known.isStatic() == fresh.isStatic();
    TransformHistory<F> history = goesOn ? known : fresh;
    if (!history.remembers(stamp, limits)) {
      return new TransformPut.Refused<>(name(fresh.parent(), child) + " is older than what is remembered");
    }
    history.add(stamp, transform, authority, limits);
    byChild.put(child, history);
    return new TransformPut.Accepted<>(moved ? Optional.of(known.parent()) : Optional.empty());
  }

  private static Optional<String> malformed(RigidTransform transform) {
    if (!transform.translation().isFinite()) {
      return Optional.of("has a translation that is not finite: " + transform.translation());
    }
    if (transform.translation().norm() > FARTHEST) {
      return Optional.of("has a translation of more than " + FARTHEST + " m: " + transform.translation());
    }
    double length = transform.rotation().norm();
    return Math.abs(length - 1) <= LENGTH_TOLERANCE
        ? Optional.empty()
        : Optional.of("has a rotation of length " + length + " instead of 1: " + transform.rotation());
  }

  private Optional<String> misplaced(F parent, F child) {
    if (parent.equals(child)) {
      return Optional.of("names one frame twice");
    }
    if (pathToRoot(parent).stream().anyMatch(edge -> edge.parent().equals(child))) {
      return Optional.of("would close a loop: '" + parent + "' is below '" + child + "'");
    }
    return !byChild.containsKey(child) && byChild.size() >= limits.maxEdges()
        ? Optional.of("is one more than the " + limits.maxEdges() + " this buffer holds")
        : Optional.empty();
  }

  private static String name(Object parent, Object child) {
    return "the transform '" + parent + "' -> '" + child + "'";
  }

  /**
   * Finds a transform at a time.
   *
   * @param target the frame to express things in
   * @param source the frame they are given in
   * @param stampNanos the time
   * @return the transform, or why there is none
   */
  public TransformLookup<F> lookup(F target, F source, long stampNanos) {
    synchronized (byChild) {
      Optional<TransformLookup<F>> failure = unconnected(target, source);
      return failure.orElseGet(() -> path(target, source).at(stampNanos));
    }
  }

  /**
   * Finds the transform at the latest time at which all edges between the frames are known.
   *
   * @param target the frame to express things in
   * @param source the frame they are given in
   * @return the transform and that time, or why there is none
   */
  public TransformLookup<F> lookupLatest(F target, F source) {
    synchronized (byChild) {
      Optional<TransformLookup<F>> failure = unconnected(target, source);
      return failure.orElseGet(() -> latest(target, source));
    }
  }

  private TransformLookup<F> latest(F target, F source) {
    FramePath<F> path = path(target, source);
    return path.latestStamp().map(path::at).orElseGet(() -> new TransformLookup.NoCommonTime<>(target, source));
  }

  private Optional<TransformLookup<F>> unconnected(F target, F source) {
    if (!isKnown(target)) {
      return Optional.of(new TransformLookup.UnknownFrame<>(target));
    }
    if (!isKnown(source)) {
      return Optional.of(new TransformLookup.UnknownFrame<>(source));
    }
    F targetRoot = rootOf(target);
    F sourceRoot = rootOf(source);
    return targetRoot.equals(sourceRoot)
        ? Optional.empty()
        : Optional.of(new TransformLookup.Disconnected<>(target, targetRoot, source, sourceRoot));
  }

  private boolean isKnown(F frame) {
    return byChild.containsKey(frame) || byChild.values().stream().anyMatch(e -> e.parent().equals(frame));
  }

  private FramePath<F> path(F target, F source) {
    return FramePath.between(pathToRoot(target), pathToRoot(source));
  }

  private List<TransformHistory<F>> pathToRoot(F frame) {
    List<TransformHistory<F>> path = new ArrayList<>();
    for (TransformHistory<F> e = byChild.get(frame); e != null; e = byChild.get(e.parent())) {
      path.add(e);
    }
    return path;
  }

  private F rootOf(F frame) {
    List<TransformHistory<F>> path = pathToRoot(frame);
    return path.isEmpty() ? frame : path.getLast().parent();
  }

  /**
   * All frames that a transform named.
   *
   * @return a copy
   */
  public Set<F> frames() {
    synchronized (byChild) {
      Set<F> frames = new HashSet<>(byChild.keySet());
      byChild.values().forEach(edge -> frames.add(edge.parent()));
      return Set.copyOf(frames);
    }
  }

  /**
   * The frame above.
   *
   * @param frame a frame
   * @return none where it is a root or unknown
   */
  public Optional<F> parentOf(F frame) {
    synchronized (byChild) {
      return Optional.ofNullable(byChild.get(frame)).map(TransformHistory::parent);
    }
  }

  /**
   * All edges, for a view of the tree.
   *
   * @return a copy, in no order
   */
  public List<FrameEdge<F>> edges() {
    synchronized (byChild) {
      return byChild.values().stream().map(TransformHistory::edge).toList();
    }
  }

  /** Forgets all samples, for a clock that jumped; static transforms stay, as they hold for all times. */
  public void clear() {
    synchronized (byChild) {
      byChild.values().removeIf(edge -> !edge.isStatic());
    }
  }
}
