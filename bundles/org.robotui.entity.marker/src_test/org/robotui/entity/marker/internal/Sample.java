package org.robotui.entity.marker.internal;

import java.util.Arrays;
import java.util.Optional;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Floats;
import org.robotui.data.marker.Color;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.MarkerSet;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/** Markers for tests. */
record Sample(String namespace, int id, Marker.Type type, String frame, RigidTransform pose, Vector3 scale, Color color,
    long lifetime,
    boolean locked, Floats points, Bytes colors, String text, String mesh, boolean materials) {
  static Sample of(int id, Marker.Type type) {
    return new Sample("things", id, type, "map", RigidTransform.planar(id, 0, 0), new Vector3(1, 1, 1),
        new Color(1, 0, 0, 1), 0, false,
        Floats.EMPTY, Bytes.EMPTY, "", "", false);
  }

  Sample in(String other) {
    return new Sample(other, id, type, frame, pose, scale, color, lifetime, locked, points, colors, text, mesh,
        materials);
  }

  Sample frame(String name, boolean moves) {
    return new Sample(namespace, id, type, name, pose, scale, color, lifetime, moves, points, colors, text, mesh,
        materials);
  }

  Sample at(double x, double y, double z, Quaternion turn) {
    return new Sample(namespace, id, type, frame, new RigidTransform(new Vector3(x, y, z), turn), scale, color,
        lifetime, locked, points, colors, text, mesh, materials);
  }

  Sample scale(double x, double y, double z) {
    return new Sample(namespace, id, type, frame, pose, new Vector3(x, y, z), color, lifetime, locked, points, colors,
        text, mesh, materials);
  }

  Sample living(long nanos) {
    return new Sample(namespace, id, type, frame, pose, scale, color, nanos, locked, points, colors, text, mesh,
        materials);
  }

  Sample points(float... xyz) {
    return new Sample(namespace, id, type, frame, pose, scale, color, lifetime, locked, Floats.of(xyz), colors, text,
        mesh, materials);
  }

  Sample saying(String words) {
    return new Sample(namespace, id, type, frame, pose, scale, color, lifetime, locked, points, colors, words, mesh,
        materials);
  }

  Sample mesh(String uri) {
    return new Sample(namespace, id, type, frame, pose, scale, color, lifetime, locked, points, colors, text, uri,
        materials);
  }

  Sample colored(Color other) {
    return new Sample(namespace, id, type, frame, pose, scale, other, lifetime, locked, points, colors, text, mesh,
        materials);
  }

  Sample withMaterials() {
    return new Sample(namespace, id, type, frame, pose, scale, color, lifetime, locked, points, colors, text, mesh,
        true);
  }

  Marker made(long now) {
    return new Marker(new Marker.Key(namespace, id), Ticks.frame(frame), Optional.empty(), now, type, pose, scale,
        color, lifetime, locked, points,
        colors, text, mesh, materials);
  }

  static MarkerSet set(long now, Sample... samples) {
    return new MarkerSet(false,
        Arrays.stream(samples).map(s -> s.made(now)).map(m -> new MarkerSet.Entry(m.key(), Optional.of(m))).toList());
  }
}
