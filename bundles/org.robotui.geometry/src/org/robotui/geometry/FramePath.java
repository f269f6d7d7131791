package org.robotui.geometry;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The edges from two frames up to the frame they have in common. Guarded by its buffer.
 *
 * @param target the edges above the target, lowest first
 * @param source the edges above the source, lowest first
 * @param <F> names a frame
 */
record FramePath<F>(List<TransformHistory<F>> target, List<TransformHistory<F>> source) {

  /** Cuts what two ways to the same root have in common. */
  static <F> FramePath<F> between(List<TransformHistory<F>> targetToRoot, List<TransformHistory<F>> sourceToRoot) {
    List<TransformHistory<F>> target = new ArrayList<>(targetToRoot);
    List<TransformHistory<F>> source = new ArrayList<>(sourceToRoot);
    while (!target.isEmpty() && !source.isEmpty() && target.getLast() == source.getLast()) {
      target.removeLast();
      source.removeLast();
    }
    return new FramePath<>(target, source);
  }

  TransformLookup<F> at(long stamp) {
    Optional<TransformHistory<F>> gap = edges().filter(e -> !e.covers(stamp)).findFirst();
    return gap.isPresent() ? outside(gap.get(), stamp) : new TransformLookup.Found<>(compose(stamp), stamp);
  }

  /** The stamp at which all that moves was last known; 0 where nothing moves; none where there is no such time. */
  Optional<Long> latestStamp() {
    Optional<Long> latest = moving().map(TransformHistory::newest).min(Comparator.naturalOrder());
    return latest.isEmpty() ? Optional.of(0L) : latest.filter(stamp -> moving().allMatch(e -> e.oldest() <= stamp));
  }

  private Stream<TransformHistory<F>> edges() {
    return Stream.concat(target.stream(), source.stream());
  }

  private Stream<TransformHistory<F>> moving() {
    return edges().filter(e -> !e.isStatic());
  }

  private static <F> TransformLookup<F> outside(TransformHistory<F> edge, long stamp) {
    return stamp < edge.oldest()
        ? new TransformLookup.TooOld<>(edge.parent(), edge.child(), edge.oldest(), stamp)
        : new TransformLookup.TooNew<>(edge.parent(), edge.child(), edge.newest(), stamp);
  }

  private RigidTransform compose(long stamp) {
    return up(target, stamp).inverse().times(up(source, stamp));
  }

  private static <F> RigidTransform up(List<TransformHistory<F>> edges, long stamp) {
    RigidTransform topFromFrame = RigidTransform.IDENTITY;
    for (TransformHistory<F> each : edges) {
      topFromFrame = each.at(stamp).times(topFromFrame);
    }
    return topFromFrame;
  }
}
