package org.robotui.xbot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.Vector3;
import org.robotui.xbot.Board;
import org.robotui.xbot.HostReading;
import org.robotui.xbot.JointReference;
import org.robotui.xbot.StateFrame;

class ReadersTest {
  private final Layout layout = Layout.shipped();

  @Test
  void aBoardIsReadAsItWasWritten() throws IOException {
    Board board = new BoardReader(layout).read(NativeFiles.vector("board")).orElseThrow();
    assertEquals("Grüner Arm", board.robot());
    assertTrue(board.realTime());
    assertEquals(List.of("shoulder_pan", "lift"), board.joints().stream().map(Board.Joint::name).toList());
    assertEquals(new Board.Host("main", 4713, 2, ""), board.hosts().getFirst());
    assertEquals(Board.PluginState.FAILED, board.plugins().getFirst().state());
    assertEquals("The joint 'elbow' is not one of this robot.", board.plugins().getFirst().error());
    assertEquals("waits", board.plugins().getFirst().status());
    assertEquals(List.of("imu_link"), board.imus());
    assertEquals(List.of(new Board.Chain("arm", List.of(1, 0))), board.chains());
  }

  @Test
  void aHostIsReadAsItWasWritten() throws IOException {
    HostReading host = new HostReader(layout).read(NativeFiles.vector("host"));
    assertEquals(2, host.threads().size());
    assertEquals("rt_main", host.threads().get(1).name());
    assertEquals(1, host.threads().get(1).wakeUp().counts().get(24));
    assertEquals(77, host.plugins().get(5).cycles());
    assertEquals(1, host.plugins().size());
    assertEquals("", host.damage());
  }

  @Test
  void theNewestFrameIsRead() throws IOException {
    StateFrame state = read(segment()).orElseThrow();
    assertEquals(0.125, state.joints().getFirst().linkPosition());
    assertEquals(StateFrame.Hardware.TIMEOUT, state.hardware());
    assertEquals(new Vector3(1, -2, 3), state.forceTorques().get(15).force());
    assertTrue(Double.isNaN(state.joints().getFirst().driverTemperature()));
  }

  private Optional<StateFrame> read(Memory memory) {
    StateReader reader = new StateReader(layout);
    return reader.read(memory, reader.newCopy());
  }

  /** A state whose newest frame is the one of the vectors. */
  private Memory segment() throws IOException {
    ByteBuffer frame = NativeFiles.vector("state-frame").copy(0, layout.size("StateFrame"));
    long cycle = frame.getLong(layout.offset("StateFrame", "data.cycle"));
    Layout.Field frames = layout.struct("StateSegment").fields().get("frames");
    ByteBuffer segment = ByteBuffer.allocateDirect(layout.size("StateSegment")).order(ByteOrder.LITTLE_ENDIAN);
    segment.putLong(layout.offset("StateSegment", "newest"), cycle);
    segment.putInt(layout.offset("StateSegment", "joints"), layout.number("joints"));
    segment.putInt(layout.offset("StateSegment", "imus"), layout.number("imus"));
    segment.putInt(layout.offset("StateSegment", "force_torques"), layout.number("force_torques"));
    segment.put(frames.offset() + (int) (cycle % frames.count()) * frames.size(), frame.array());
    return new Memory(segment);
  }

  @Test
  void beforeTheFirstCycleThereIsNoFrame() {
    Memory empty = new Memory(ByteBuffer.allocateDirect(layout.size("StateSegment")));
    assertTrue(read(empty).isEmpty());
  }

  @Test
  void whatAWriterLeftHalfWrittenIsNotBelieved() throws IOException {
    ByteBuffer bytes = ByteBuffer.allocateDirect(layout.size("BoardSegment")).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putLong(layout.offset("BoardSegment", "sequence"), 7);
    assertTrue(new BoardReader(layout).read(new Memory(bytes)).isEmpty());
  }

  @Test
  void aThreadByDeadlineIsNoDamage() throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap(NativeFiles.vector("host").copy(0, layout.size("HostSegment")).array())
        .order(ByteOrder.LITTLE_ENDIAN);
    int priority = layout.struct("HostSegment").fields().get("thread_statistics").offset()
        + layout.offset("ThreadStatistics", "priority");
    bytes.putInt(priority, 100);
    assertEquals("", new HostReader(layout).read(new Memory(bytes)).damage());
    bytes.putInt(priority, 101);
    assertEquals("what it says of its threads is overwritten", new HostReader(layout).read(new Memory(bytes)).damage());
  }

  @Test
  void aHostMayWriteAnything() {
    Random random = new Random(4);
    byte[] bytes = new byte[layout.size("HostSegment")];
    for (int i = 0; i < 200; i++) {
      random.nextBytes(bytes);
      ByteBuffer direct = ByteBuffer.allocateDirect(bytes.length).put(bytes).flip();
      HostReading host = new HostReader(layout).read(new Memory(direct));
      assertEquals("its head is overwritten", host.damage());
      assertEquals(List.of(), host.threads());
    }
  }

  /** The head stays, as one wild write seldom hits all. */
  @Test
  void whatAHostOverwroteIsNamedAndNotShown() throws IOException {
    Random random = new Random(5);
    byte[] sound = NativeFiles.vector("host").copy(0, layout.size("HostSegment")).array();
    int threads = layout.struct("HostSegment").fields().get("thread_statistics").offset();
    for (int i = 0; i < 200; i++) {
      byte[] wild = new byte[layout.size("PluginStatistics")];
      random.nextBytes(wild);
      byte[] bytes = sound.clone();
      System.arraycopy(wild, 0, bytes, threads + random.nextInt(bytes.length - threads - wild.length), wild.length);
      HostReading host = new HostReader(layout).read(new Memory(ByteBuffer.wrap(bytes)));
      assertTrue(host.damage().matches("what it says of its (threads|plugins) is overwritten"), host.damage());
      assertEquals(List.of(), host.threads());
    }
  }

  @Test
  void referencesAreWrittenAsTheNativeSideWritesThem() throws IOException {
    int at = layout.struct("HostSegment").fields().get("slots").offset() + layout.size("CommandSlot")
        + layout.offset("CommandSlot", "data.joints");
    ByteBuffer wanted = NativeFiles.vector("host").copy(at, layout.size("JointCommand"));
    wanted.putShort(layout.offset("JointCommand", "plugin"), (short) 0); // which means nothing in a reference
    ByteBuffer written = new References(layout).write(
        List.of(new JointReference(0, new StateFrame.Reference(0.5, 1.5, -2.5, 300, 3), 25)), 2);
    assertEquals(wanted, written.slice(0, layout.size("JointCommand")));
  }

  @Test
  void jointsThatAreNotNamedAreToldNothing() {
    References references = new References(layout);
    references.write(List.of(new JointReference(1, new StateFrame.Reference(1, 1, 1, 1, 1), 31)), 2);
    ByteBuffer written = references.write(List.of(), 2);
    for (int i = 0; i < 2 * layout.size("JointCommand"); i++) {
      assertEquals(0, written.get(i));
    }
  }
}
