package org.robotui.rfic.smartsoft.internal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.FrameId;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.geometry.RigidTransform;
import org.robotui.message.DynamicMessage;
import org.robotui.rfic.smartsoft.internal.convert.SmartPlaces;
import org.robotui.rfic.smartsoft.internal.convert.SmartSensing;
import org.robotui.smartsoft.object.CommTypes;

/** Units of SmartSoft as SI units. */
class SmartConvertTest {
  private static final FrameId FRAME = new FrameId("robby", "map");
  private final RobotFrames frames = SmartPeer.settings(Map.of()).frames().of("robby");

  private static DynamicMessage make(String type, Map<String, Object> values) throws Exception {
    return CommTypes.shipped().get(type).make(values);
  }

  @Test
  void a_pose_is_turned_about_z_first() throws Exception {
    RigidTransform pose = SmartPlaces.pose(make("CommBasicObjects::CommPose3d", Map.of("position",
        Map.of("x", 1000, "z", 500), "orientation", Map.of("azimuth", Math.PI / 2))));
    assertEquals(1, pose.translation().x());
    assertEquals(0.5, pose.translation().z());
    assertEquals(Math.PI / 2, pose.rotation().yaw(), 1e-12);
  }

  @Test
  void a_covariance_has_metres_where_it_is_valid() throws Exception {
    Map<String, Object> place =
        Map.of("covMatrix", List.of(10_000, 0, 500, 0, 40_000, 0, 500, 0, 0.25), "pose3D", Map.of());
    PoseEstimate estimate =
        SmartPlaces.estimate(make("CommBasicObjects::CommBaseState", Map.of("basePose", place)), frames);
    assertEquals(0.01, estimate.covariance().get(0), 1e-12);
    assertEquals(0.04, estimate.covariance().get(7), 1e-12);
    assertEquals(0.5, estimate.covariance().get(5), 1e-12);
    assertEquals(0.25, estimate.covariance().get(35));
    PoseEstimate unsure = SmartPlaces.estimate(make("CommBasicObjects::CommBaseState",
        Map.of("basePose", Map.of("covInvalid", true))), frames);
    assertEquals(0, unsure.covariance().size());
  }

  @Test
  void a_battery_is_charged_where_power_comes_from_outside() throws Exception {
    Battery battery = SmartPlaces.battery(make("CommBasicObjects::CommBaseState", Map.of("batteryState",
        Map.of("potential", 24.5, "chargeLevel", 80, "externalPower", true))));
    assertEquals(new Battery(24.5, 0, 0.8, Battery.Status.CHARGING), battery);
  }

  @Test
  void cells_of_a_map_are_free_occupied_or_unknown() throws Exception {
    GridMap map = SmartSensing.map(make("CommNavigationObjects::CommGridMap",
        Map.of("xOffsetMM", -2000, "yOffsetMM", 1000, "cellSizeMM", 50, "xSizeCells", 3, "ySizeCells", 2, "cell",
            List.of(0, 64, 127, 128, 205, 131))),
        FRAME);
    assertEquals(0.05, map.resolution());
    assertEquals(-2, map.origin().translation().x());
    byte[] cells = new byte[6];
    map.cells().copyTo(0, cells, 0, 6);
    assertArrayEquals(new byte[]{0, 50, 100, 100, GridMap.UNKNOWN, 100}, cells);
    assertThrows(IllegalArgumentException.class, () -> SmartSensing.map(make("CommNavigationObjects::CommGridMap",
        Map.of("cellSizeMM", 50, "xSizeCells", 100_000, "ySizeCells", 100_000)), FRAME));
  }

  @Test
  void a_fix_has_radians() throws Exception {
    GpsFix fix = SmartSensing.fix(make("CommLocalizationObjects::CommGpsFix", Map.of("is_2D", true, "latitude", 48.4,
        "longitude", 9.99, "latitude_uncertainty", 6, "longitude_uncertainty", 8)), FRAME);
    assertEquals(Math.toRadians(48.4), fix.latitude());
    assertEquals(5, fix.horizontalAccuracy(), 1e-12);
    assertTrue(Double.isNaN(fix.altitude()));
  }

  @Test
  void infrared_sensors_have_frames_of_their_own() throws Exception {
    RangeReadings readings = SmartSensing.infrared(make("CommBasicObjects::CommIRScan",
        Map.of("distance_min", 0.04, "distance_max", 0.4, "distances", List.of(0.1, 0.3))), frames, "base/ir");
    assertEquals("base/ir_1", readings.readings().get(1).frame().name());
    assertEquals(0.3, readings.readings().get(1).range());
  }
}
