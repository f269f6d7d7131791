package org.robotui.rfic.foxglove.internal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Floats;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.sensor.LaserScan;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.rfic.Sample;
import org.robotui.web.tree.JsonText;
import org.robotui.web.tree.TreeException;
import org.robotui.web.tree.Trees;

/** As a program with Foxglove's library speaks: its schemas in JSON and Protocol Buffers, and no connection graph. */
record SchemaDialect() implements Dialect {
  private static final Stamp STAMP = Stamp.of(1_700_000_000L, 500, ClockKind.ROBOT);
  private static final Sample POSE = new Sample("pose",
      new StampedPose(new FrameId("robby", "map"), new RigidTransform(new Vector3(1, -2, 3), Quaternion.fromYaw(0.5))),
      Optional.of(STAMP));
  private static final Sample SCAN = new Sample("front/scan",
      new LaserScan(new FrameId("robby", "laser"), -1, 1, 0, 2, 0, Floats.of(1, 2, Float.POSITIVE_INFINITY),
          Floats.EMPTY),
      Optional.of(STAMP));

  @Override
  public List<String> capabilities() {
    return List.of("clientPublish");
  }

  @Override
  public List<String> encodings() {
    return List.of("json");
  }

  @Override
  public void offer(FoxgloveServer server) {
    server.channel(0, "pose", "json", "foxglove.PoseInFrame", "jsonschema", "{\"type\":\"object\"}");
    server.channel(1, "/front/scan", "protobuf", "foxglove.LaserScan", "protobuf", ProtobufScan.DESCRIPTORS);
  }

  @Override
  public List<Sample> samples() {
    return List.of(POSE, SCAN);
  }

  @Override
  public ByteBuffer message(int channel) {
    if (channel == 1) {
      return ProtobufScan.message("laser", STAMP.nanos(), -1, 1, 1, 2, Double.POSITIVE_INFINITY);
    }
    Map<String, Object> pose = Map.of("position", Map.of("x", 1, "y", -2, "z", 3), "orientation",
        Map.of("x", 0, "y", 0, "z", Math.sin(0.25), "w", Math.cos(0.25)));
    return ByteBuffer.wrap(JsonText.write(Map.of("timestamp", Map.of("sec", 1_700_000_000, "nsec", 500), "frame_id",
        "map", "pose", pose)).getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public Data heard(FoxgloveServer.Said said) {
    try {
      Map<String, Object> twist =
          Trees.object(JsonText.read(StandardCharsets.UTF_8.decode(said.payload()).toString()));
      return new VelocityCommand(vector(twist.get("linear")), vector(twist.get("angular")));
    } catch (TreeException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Vector3 vector(Object tree) throws TreeException {
    Map<String, Object> v = Trees.object(tree);
    return new Vector3(number(v, "x"), number(v, "y"), number(v, "z"));
  }

  private static double number(Map<String, Object> v, String axis) {
    return ((Number) v.get(axis)).doubleValue();
  }
}
