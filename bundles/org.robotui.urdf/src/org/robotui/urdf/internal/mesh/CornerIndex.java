package org.robotui.urdf.internal.mesh;

import java.util.Arrays;

/** Finds a corner again by the position, normal and place in the texture that make it. */
final class CornerIndex {
  private int[] keys = new int[3 * 64];
  private int[] corners = filled(64);
  private int size;

  /** The corner, or -1. */
  int get(int position, int normal, int place) {
    return corners[slot(position, normal, place)];
  }

  void put(int position, int normal, int place, int corner) {
    if (2 * size > corners.length) {
      grow();
    }
    int slot = slot(position, normal, place);
    keys[3 * slot] = position;
    keys[3 * slot + 1] = normal;
    keys[3 * slot + 2] = place;
    corners[slot] = corner;
    size++;
  }

  private int slot(int position, int normal, int place) {
    int mask = corners.length - 1;
    int hash = (position * 0x9E3779B1 + normal) * 0x85EBCA77 + place;
    int slot = (hash ^ hash >>> 15) & mask;
    while (corners[slot] >= 0
        && (keys[3 * slot] != position || keys[3 * slot + 1] != normal || keys[3 * slot + 2] != place)) {
      slot = slot + 1 & mask;
    }
    return slot;
  }

  private void grow() {
    int[] oldKeys = keys;
    int[] oldCorners = corners;
    keys = new int[2 * oldKeys.length];
    corners = filled(2 * oldCorners.length);
    size = 0;
    for (int i = 0; i < oldCorners.length; i++) {
      if (oldCorners[i] >= 0) {
        put(oldKeys[3 * i], oldKeys[3 * i + 1], oldKeys[3 * i + 2], oldCorners[i]);
      }
    }
  }

  private static int[] filled(int length) {
    int[] empty = new int[length];
    Arrays.fill(empty, -1);
    return empty;
  }
}
