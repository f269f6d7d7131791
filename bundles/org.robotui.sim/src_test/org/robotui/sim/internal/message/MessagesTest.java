package org.robotui.sim.internal.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.ros.geometry_msgs.TransformStamped;
import org.robotui.message.ros.nav_msgs.OccupancyGrid;
import org.robotui.message.ros.nav_msgs.Odometry;
import org.robotui.message.ros.sensor_msgs.BatteryState;
import org.robotui.message.ros.sensor_msgs.CompressedImage;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.message.ros.sensor_msgs.LaserScan;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.sim.internal.Command;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.Settings;
import org.robotui.sim.internal.Simulation;
import org.robotui.sim.internal.camera.JpegEncoder;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.camera.Renderer;
import org.robotui.sim.internal.model.Robots;
import org.robotui.sim.internal.robot.Speed;
import org.robotui.sim.internal.sensor.LaserSpec;
import org.robotui.sim.internal.world.GridMap;
import org.robotui.sim.internal.world.MapRasterizer;
import org.robotui.sim.internal.world.Pose2;
import org.robotui.sim.internal.world.World;

class MessagesTest {
  private static final Stamp STAMP = new Stamp(3, 1_700_000_000_123_456_789L);
  private final Frames frames = new Frames("keira");
  private final World world = World.demo();
  private final GridMap map = new MapRasterizer(world, 0.05, 0.3).rasterize();

  private RobotState drivenState() {
    Simulation simulation = new Simulation(world, map, Settings.demo(3), event -> {});
    for (int i = 0; i < 300; i++) {
      simulation.submit(new Command.Drive(new Speed(0.4, 0.3)));
      simulation.step();
    }
    return simulation.state();
  }

  @Test
  void theTreeOfTransformsLeadsFromTheMapToWhereTheRobotIs() {
    RobotState state = drivenState();
    TFMessage tf = new BaseMessages(frames, Robots.NATALIE).transforms(state, STAMP);
    TransformStamped first = tf.transforms().get(0);
    TransformStamped second = tf.transforms().get(1);
    assertEquals("map", first.header().frameId());
    assertEquals("keira/odom", first.childFrameId());
    assertEquals(first.childFrameId(), second.header().frameId());
    assertEquals("keira/base_link", second.childFrameId());
    Vector3 place = transform(first).times(transform(second)).translation();
    assertEquals(state.truth().x(), place.x(), 0.05);
    assertEquals(state.truth().y(), place.y(), 0.05);
  }

  private static RigidTransform transform(TransformStamped stamped) {
    var t = stamped.transform().translation();
    var q = stamped.transform().rotation();
    return new RigidTransform(new Vector3(t.x(), t.y(), t.z()), new Quaternion(q.x(), q.y(), q.z(), q.w()));
  }

  @Test
  void theCameraLooksForwardAlongItsOpticalAxis() {
    TFMessage tf = new StaticTransforms(frames).message(Robots.NATALIE, STAMP);
    assertEquals(22, tf.transforms().size());
    TransformStamped optical = tf.transforms().stream()
        .filter(t -> t.childFrameId().equals("keira/camera_optical")).findFirst().orElseThrow();
    Vector3 ahead = transform(optical).apply(new Vector3(0, 0, 1));
    Vector3 right = transform(optical).apply(new Vector3(1, 0, 0));
    assertEquals(1, ahead.x(), 1e-9);
    assertEquals(-1, right.y(), 1e-9);
  }

  @Test
  void theHeadTurnsAsItsJointsSay() {
    RobotState state = drivenState();
    TFMessage tf = new BaseMessages(frames, Robots.NATALIE).transforms(state, STAMP);
    var joints = new BaseMessages(frames, Robots.NATALIE).joints(state, STAMP);
    assertEquals("pan_joint", joints.name().get(2));
    RigidTransform pan = transform(tf.transforms().get(2));
    assertEquals(joints.position()[2], pan.rotation().yaw(), 1e-9);
    Vector3 look = pan.times(transform(tf.transforms().get(3))).rotation().rotate(new Vector3(1, 0, 0));
    assertEquals(-Math.sin(joints.position()[3]), look.z(), 1e-9);
  }

  @Test
  void depthsAreMillimetresInLittleEndian() {
    short[] depths = new short[320 * 240];
    depths[1] = (short) 40_000;
    Image image = new CameraMessages(frames, Lens.DEMO).depth(depths, STAMP);
    assertEquals("16UC1", image.encoding());
    assertEquals(image.step() * image.height(), image.data().remaining());
    assertEquals(40_000, (image.data().get(2) & 255) + 256 * (image.data().get(3) & 255));
  }

  @Test
  void odometryCarriesSpeedAndFrames() {
    Odometry odometry = new BaseMessages(frames, Robots.NATALIE).odometry(drivenState(), STAMP);
    assertEquals(0.4, odometry.twist().twist().linear().x(), 1e-9);
    assertEquals("keira/base_link", odometry.childFrameId());
    assertEquals(STAMP.nanos(), odometry.header().stamp());
    assertEquals(3, odometry.header().seq());
  }

  @Test
  void theScanSpansItsField() {
    LaserScan scan = new SensorMessages(frames).scan(LaserSpec.DEMO, new float[361], STAMP);
    assertEquals(scan.angleMax(), scan.angleMin() + 360 * scan.angleIncrement(), 1e-4);
  }

  @Test
  void theMapHasOneByteACellInTheOrderOfRos() {
    OccupancyGrid grid = new SensorMessages(frames).map(map, STAMP);
    assertEquals(grid.info().width() * grid.info().height(), grid.data().remaining());
    int start = map.row(world.start().y()) * map.width() + map.column(world.start().x());
    assertEquals(0, grid.data().get(start));
    assertEquals(-1, grid.data().get(0));
  }

  @Test
  void theBatterySaysWhatItDoes() {
    BatteryState battery = new BaseMessages(frames, Robots.NATALIE).battery(drivenState(), STAMP);
    assertEquals(BatteryState.POWER_SUPPLY_STATUS_DISCHARGING, battery.powerSupplyStatus());
    assertTrue(battery.current() < -1.5);
    assertEquals(0.87, battery.percentage(), 0.01);
  }

  @Test
  void rawAndCompressedPicturesShowTheSame() throws IOException {
    int[] pixels = new Renderer(world, Lens.DEMO).render(new Pose2(1, 5, 0), Optional.empty(), Optional.empty());
    CameraMessages messages = new CameraMessages(frames, Lens.DEMO);
    Image raw = messages.raw(pixels, STAMP);
    assertEquals(raw.step() * raw.height(), raw.data().remaining());
    assertEquals((byte) (pixels[1000] >> 16), raw.data().get(3000));
    byte[] jpeg = new JpegEncoder(320, 240).encode(pixels);
    CompressedImage compressed = messages.compressed(jpeg, STAMP);
    assertEquals(jpeg.length, compressed.data().remaining());
    var decoded = ImageIO.read(new ByteArrayInputStream(jpeg));
    assertNotNull(decoded);
    assertEquals(320, decoded.getWidth());
    int middle = 200 * 320 + 160;
    assertEquals(pixels[middle] >> 16 & 255, decoded.getRGB(160, 200) >> 16 & 255, 25);
  }
}
