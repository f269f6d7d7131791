package org.robotui.rfic.recording.internal.report;

import java.util.ArrayList;
import java.util.List;
import org.robotui.geometry.Vector3;

/** Where something drove, with as many places as a figure can show. For one thread. */
final class DrivenPath {
  private static final int MOST = 4000;
  /** A localisation that is set elsewhere has not driven there. */
  private static final double JUMP = 2;

  private final String port;
  private final String frame;
  private final List<Vector3> places = new ArrayList<>();
  private Vector3 last;
  private double length;
  private int jumps;
  private long seen;
  private int stride = 1;

  DrivenPath(String port, String frame, Vector3 start) {
    this.port = port;
    this.frame = frame;
    this.last = start;
  }

  void take(Vector3 place) {
    double step = place.minus(last).norm();
    if (step > JUMP) {
      jumps++;
    } else {
      length += step;
    }
    last = place;
    if (seen++ % stride == 0) {
      places.add(place);
      thin();
    }
  }

  private void thin() {
    if (places.size() >= MOST) {
      for (int i = places.size() / 2 - 1; i >= 0; i--) {
        places.remove(2 * i + 1);
      }
      stride *= 2;
    }
  }

  String port() {
    return port;
  }

  String frame() {
    return frame;
  }

  /** In metres, without jumps. */
  double length() {
    return length;
  }

  int jumps() {
    return jumps;
  }

  Vector3 end() {
    return last;
  }

  List<Vector3> places() {
    return List.copyOf(places);
  }
}
