package org.robotui.sim.internal.message;

import java.nio.ByteBuffer;
import org.robotui.message.ros.nav_msgs.MapMetaData;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.sensor_msgs.NavSatFix;
import org.robotui.message.ros.sensor_msgs.NavSatStatus;
import org.robotui.message.ros.sensor_msgs.Range;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.sensor.SatelliteReceiver;
import org.robotui.sim.internal.sensor.SonarSpec;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.Pose2;

/** Messages of the range sensors, and the map. */
final class SensorMessages {
  private final Frames frames;

  SensorMessages(Frames frames) {
    this.frames = frames;
  }

  LaserScan scan(LaserSpec spec, float[] ranges, Stamp stamp) {
    return new LaserScan(
        stamp.header(frames.laser()),
        (float) spec.angleMin(), (float) -spec.angleMin(), (float) spec.increment(),
        0, (float) (1 / spec.frequency()), (float) spec.rangeMin(), (float) spec.rangeMax(), ranges, new float[0]);
  }

  Range sonar(SonarSpec spec, int index, double range, Stamp stamp) {
    return new Range(
        stamp.header(frames.sonar(index)), Range.ULTRASOUND, (float) spec.cone(),
        (float) spec.rangeMin(), (float) spec.rangeMax(), (float) range);
  }

  NavSatFix fix(SatelliteReceiver.Fix fix, Stamp stamp) {
    double variance = SatelliteReceiver.ERROR * SatelliteReceiver.ERROR;
    return new NavSatFix(
        stamp.header(frames.satellites()), new NavSatStatus(NavSatStatus.STATUS_FIX, NavSatStatus.SERVICE_GPS),
        fix.latitude(), fix.longitude(), fix.altitude(),
        new double[]{variance, 0, 0, 0, variance, 0, 0, 0, 4 * variance}, NavSatFix.COVARIANCE_TYPE_DIAGONAL_KNOWN);
  }

  OccupancyGrid map(GridMap map, Stamp stamp) {
    MapMetaData info = new MapMetaData(
        stamp.nanos(), (float) map.resolution(), map.width(), map.height(),
        Poses.pose(new Pose2(map.originX(), map.originY(), 0)));
    return new OccupancyGrid(stamp.header(Frames.MAP), info, ByteBuffer.wrap(map.cells()));
  }
}
