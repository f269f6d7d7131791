package org.robotui.uic.scene3d.recorded;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.entity.gridmap.internal.display.GridMapType;
import org.robotui.entity.image.internal.display.CameraType;
import org.robotui.entity.image.internal.display.ImageType;
import org.robotui.entity.laserscan.internal.display.LaserScanType;
import org.robotui.entity.marker.internal.MarkersType;
import org.robotui.entity.odometry.internal.display.OdometryType;
import org.robotui.entity.pointcloud.internal.PointCloudType;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayType;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageRegistry;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.FrameNames;
import org.robotui.rfic.ros.internal.convert.MessageReading;
import org.robotui.rfic.ros.internal.convert.RecordDecoder;
import org.robotui.testkit.Effort;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;
import org.robotui.testkit.recorded.BagReader;
import org.robotui.testkit.recorded.BagReader.Recorded;
import org.robotui.testkit.recorded.SharedData;

/**
 * Recorded messages with damaged bytes, from the wire to the displays: refused in words, or shown; nothing else, and
 * within bounds.
 */
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class DamagedRecordingsTest {
  private static final List<DisplayType> TYPES =
      List.of(new LaserScanType(), new PointCloudType(), new GridMapType(), new OdometryType(),
          new MarkersType(), new ImageType(), new CameraType());
  private static final FrameNames NAMES = new FrameNames(FakePlaces.ROBOT, ClockKind.ROBOT);
  private static final int ROUNDS = 150;
  private static final int HEAD = 400;
  private static final int[] WHOLE = {-1, 0, 1, 13, 1 << 16, 1 << 28, Integer.MAX_VALUE, Integer.MIN_VALUE};
  private static final double[] NUMBERS = {Double.NaN, Double.POSITIVE_INFINITY, 1e300, -1, 0};
  /** The largest picture of the recordings has six megabytes; a cloud needs up to thrice its bytes. */
  private static final long MOST_BYTES = 64 << 20;

  private static final RecordDecoder RECORDS =
      new RecordDecoder(new MessageRegistry(new LocalDefinitions(List.of(), List.of())));
  private final Adapters adapters = new Adapters();
  private final SplittableRandom random = new SplittableRandom(20261122);

  @ParameterizedTest
  @ValueSource(strings = {"sena_loop.bag", "lidar_clouds.bag", "stereo_jpeg.bag", "marker_cube.bag"})
  @Timeout(1_200)
  void damagedMessagesAreRefusedInWordsOrShown(String bag) {
    Map<String, Recorded> byType = new LinkedHashMap<>();
    BagReader
        .read(SharedData.files("bags", ".bag").stream().filter(file -> file.endsWith(bag)).findFirst().orElseThrow())
        .forEach(message -> byType.putIfAbsent(message.type(), message));
    int shown = 0;
    int refused = 0;
    for (Recorded message : byType.values()) {
      for (Effort effort = Effort.of(ROUNDS, Duration.ofSeconds(20)); effort.goesOn();) {
        Optional<? extends Data> value = decode(adapters.of(message.type()), message, damage(message.bytes()));
        shown += value.map(this::show).orElse(0);
        refused += value.isEmpty() ? 1 : 0;
      }
    }
    assertTrue(shown > 0, "nothing came through");
    assertTrue(refused > 0, "nothing was refused");
  }

  private static <M, D extends Data> Optional<D> decode(Adapter<M, D> adapter, Recorded message, byte[] bytes) {
    MessageInfo info = new MessageInfo(message.type(), message.md5(), message.definition());
    try {
      return adapter.convert().apply(
          MessageReading.of(adapter.form(), RECORDS).read(ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN), info),
          NAMES);
    } catch (MessageException | IllegalArgumentException e) {
      assertTrue(e.getMessage() != null && !e.getMessage().isBlank(), e::toString);
      return Optional.empty();
    }
  }

  /** How many displays had something to say of it. */
  private int show(Data value) {
    int some = 0;
    for (DisplayType type : TYPES) {
      if (type.accepts().stream().anyMatch(accepted -> accepted.isInstance(value))) {
        try (DisplayProbe probe = new DisplayProbe(type)) {
          probe.places().knowAll();
          probe.tick(value);
          DisplayResult result = probe.tick();
          long bytes = result.parts().stream().mapToLong(part -> part.shape().bytes()).sum();
          assertTrue(bytes < MOST_BYTES, () -> bytes + " bytes of " + type.id());
          some += result.status().words().isBlank() ? 0 : 1;
        }
      }
    }
    return some;
  }

  /** At the beginning, where lengths, offsets and poses are. */
  private byte[] damage(ByteBuffer original) {
    byte[] bytes = new byte[original.remaining()];
    original.duplicate().get(bytes);
    ByteBuffer into = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    for (int changes = random.nextInt(1, 4); changes > 0; changes--) {
      int at = random.nextInt(Math.max(1, Math.min(HEAD, bytes.length) - Double.BYTES));
      switch (random.nextInt(4)) {
        case 0 -> into.putInt(at, WHOLE[random.nextInt(WHOLE.length)]);
        case 1 -> into.putDouble(at, NUMBERS[random.nextInt(NUMBERS.length)]);
        case 2 -> into.putFloat(at, (float) NUMBERS[random.nextInt(NUMBERS.length)]);
        default -> into.put(at, (byte) random.nextInt(256));
      }
    }
    return random.nextInt(8) == 0 ? Arrays.copyOf(bytes, random.nextInt(bytes.length)) : bytes;
  }
}
