package org.robotui.geometry;

import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/** The samples of one edge, by stamp; a static edge has one that holds for all times. Guarded by its buffer. */
final class TransformHistory<F> {
  private final F parent;
  private final F child;
  private final boolean isStatic;
  private final NavigableMap<Long, RigidTransform> samples = new TreeMap<>();
  private String authority = "";

  TransformHistory(F parent, F child, boolean isStatic) {
    this.parent = parent;
    this.child = child;
    this.isStatic = isStatic;
  }

  F parent() {
    return parent;
  }

  F child() {
    return child;
  }

  boolean isStatic() {
    return isStatic;
  }

  long oldest() {
    return samples.firstKey();
  }

  long newest() {
    return samples.lastKey();
  }

  boolean remembers(long stamp, TransformLimits limits) {
    return isStatic || samples.isEmpty() || stamp >= newest() - limits.cacheNanos();
  }

  void add(long stamp, RigidTransform parentFromChild, String from, TransformLimits limits) {
    boolean isNewest = samples.isEmpty() || stamp >= newest();
    samples.put(isStatic ? 0L : stamp, parentFromChild);
    if (isStatic || isNewest) {
      authority = from;
    }
    samples.headMap(newest() - limits.cacheNanos(), false).clear();
    if (samples.size() > limits.maxSamples()) {
      samples.pollFirstEntry();
    }
  }

  boolean covers(long stamp) {
    return isStatic || oldest() <= stamp && stamp <= newest();
  }

  /** The transform at a time that is covered. */
  RigidTransform at(long stamp) {
    if (isStatic) {
      return samples.firstEntry().getValue();
    }
    Map.Entry<Long, RigidTransform> before = samples.floorEntry(stamp);
    Map.Entry<Long, RigidTransform> after = samples.ceilingEntry(stamp);
    if (before.getKey().equals(after.getKey())) {
      return before.getValue();
    }
    double t = (double) (stamp - before.getKey()) / (after.getKey() - before.getKey());
    return before.getValue().interpolate(after.getValue(), t);
  }

  FrameEdge<F> edge() {
    return new FrameEdge<>(
        parent, child, isStatic, isStatic ? 0 : oldest(), isStatic ? 0 : newest(), samples.size(), authority);
  }
}
