package org.robotui.bridge.internal.far;

import org.robotui.data.Data;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.geometry.Wrench;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.Image;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.LogEntry;

/** Knows the data types of which it is sure that they command nothing, whatever topic they are said on. */
final class Informing {
  private Informing() {}

  static boolean is(Data value) {
    return switch (value) {
      case LaserScan known -> true;
      case PointCloud known -> true;
      case RangeReadings known -> true;
      case Bumpers known -> true;
      case Imu known -> true;
      case GpsFix known -> true;
      case Battery known -> true;
      case Image known -> true;
      case CameraInfo known -> true;
      case Odometry known -> true;
      case GridMap known -> true;
      case TransformSet known -> true;
      case Footprint known -> true;
      case Wrench known -> true;
      case Diagnostics known -> true;
      case LogEntry known -> true;
      case NavigationStatus known -> true;
      default -> false;
    };
  }
}
