package org.robotui.rfic.player.internal.device;

import org.robotui.data.FrameId;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.image.Image;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.PointCloud;
import org.robotui.player.interfaces.Camera;
import org.robotui.player.interfaces.Fiducial;
import org.robotui.player.interfaces.Gps;
import org.robotui.player.interfaces.Imu;
import org.robotui.player.interfaces.Pointcloud3d;
import org.robotui.player.interfaces.Power;
import org.robotui.rfic.player.internal.convert.Pictures;
import org.robotui.rfic.player.internal.convert.PlayerPlaces;
import org.robotui.rfic.player.internal.convert.Sensing;
import org.robotui.rfic.player.internal.convert.States;

/** Interfaces of which each message is a value of its own. */
final class Simple {
  private Simple() {}

  static void power(DeviceFeed feed) {
    Outlet<Battery> outlet = feed.outlet("", Battery.class, "how much energy there is");
    feed.on(Power.STATE, outlet, (m, r) -> outlet.publish(States.battery(m), r));
  }

  static void camera(DeviceFeed feed) {
    Outlet<Image> outlet = feed.outlet("", Image.class, "its pictures");
    FrameId frame = Mount.inTheMiddle(feed);
    feed.on(Camera.IMAGE, outlet, (m, r) -> outlet.publish(Pictures.of(m, frame), r));
  }

  static void imu(DeviceFeed feed) {
    Outlet<org.robotui.data.sensor.Imu> outlet =
        feed.outlet("", org.robotui.data.sensor.Imu.class, "orientation, turning and acceleration");
    FrameId frame = Mount.inTheMiddle(feed);
    feed.on(Imu.STATE, outlet, (m, r) -> outlet.publish(Sensing.imu(m, frame), r));
    feed.on(Imu.CALIBRATED, outlet, (m, r) -> outlet.publish(Sensing.imu(m, frame), r));
    feed.on(Imu.QUATERNION, outlet, (m, r) -> outlet.publish(Sensing.imu(m, frame), r));
    feed.on(Imu.EULER, outlet, (m, r) -> outlet.publish(Sensing.imu(m, frame), r));
    feed.on(Imu.FULL_STATE, outlet, (m, r) -> outlet.publish(Sensing.imu(m, frame), r));
  }

  static void gps(DeviceFeed feed) {
    Outlet<GpsFix> outlet = feed.outlet("", GpsFix.class, "where its antenna is on earth");
    FrameId frame = Mount.inTheMiddle(feed);
    feed.on(Gps.STATE, outlet, (m, r) -> outlet.publish(Sensing.fix(m, frame), r));
  }

  static void cloud(DeviceFeed feed) {
    Outlet<PointCloud> outlet = feed.outlet("", PointCloud.class, "the points that it sees");
    FrameId frame = Mount.inTheMiddle(feed);
    feed.on(Pointcloud3d.STATE, outlet, (m, r) -> outlet.publish(Sensing.cloud(m, frame), r));
  }

  /** Where markers are, for scenes; their numbers are in the record of the message. */
  static void fiducial(DeviceFeed feed) {
    Outlet<PoseArray> outlet = feed.outlet("", PoseArray.class, "the markers that it sees");
    FrameId frame = Mount.of(feed, Fiducial.GET_GEOMETRY, Fiducial.Geometry::pose);
    feed.on(Fiducial.SCAN, outlet, (m, r) -> outlet.publish(PlayerPlaces.markers(m, frame), r));
  }
}
