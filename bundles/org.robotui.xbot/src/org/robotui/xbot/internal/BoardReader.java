package org.robotui.xbot.internal;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.robotui.xbot.Board;
import org.robotui.xbot.Board.PluginState;

/** Reads what the supervisor writes. */
public final class BoardReader {
  private static final PluginState[] STATES = PluginState.values();

  private final Layout layout;
  private final int data;
  private final int size;
  private final int sequence;
  private final int name;
  private final int text;

  /** A reader of boards of this layout. */
  public BoardReader(Layout layout) {
    this.layout = layout;
    this.data = layout.offset("BoardSegment", "data");
    this.size = layout.size("BoardData");
    this.sequence = layout.offset("BoardSegment", "sequence");
    this.name = layout.size("Name");
    this.text = layout.size("Text");
  }

  /** Another one where something else was written since; odd while it is. */
  long version(Memory memory) {
    return memory.acquireLong(sequence);
  }

  /** What stands there; none where the supervisor died while it wrote. */
  public Optional<Board> read(Memory memory) {
    return memory.consistent(sequence, data, size).map(this::board);
  }

  private Board board(ByteBuffer from) {
    return new Board(
        name(from, "robot"),
        name(from, "hal"),
        number(from, "real_time") != 0,
        number(from, "hal_respawns"),
        many(from, "joints", "joint", at -> joint(from, at)),
        many(from, "imus", "imu", at -> Memory.text(from, at, name)),
        many(from, "force_torques", "force_torque", at -> Memory.text(from, at, name)),
        many(from, "hosts", "host", at -> host(from, at)),
        many(from, "plugins", "plugin", at -> plugin(from, at)),
        many(from, "chains", "chain", at -> chain(from, at)));
  }

  private String name(ByteBuffer from, String field) {
    return Memory.text(from, layout.offset("BoardData", field), name);
  }

  private long number(ByteBuffer from, String field) {
    return Integer.toUnsignedLong(from.getInt(layout.offset("BoardData", field)));
  }

  private <T> List<T> many(ByteBuffer from, String count, String field, IntFunction<T> one) {
    Layout.Field room = layout.struct("BoardData").fields().get(field);
    long there = Math.min(number(from, count), room.count());
    List<T> all = new ArrayList<>();
    for (int i = 0; i < there; i++) {
      all.add(one.apply(room.offset() + i * room.size()));
    }
    return all;
  }

  private int at(String struct, int base, String field) {
    return base + layout.offset(struct, field);
  }

  private Board.Joint joint(ByteBuffer from, int at) {
    return new Board.Joint(
        Memory.text(from, at("JointEntry", at, "name"), name),
        from.getInt(at("JointEntry", at, "id")),
        from.getInt(at("JointEntry", at, "type")) == 1,
        from.getDouble(at("JointEntry", at, "lower")),
        from.getDouble(at("JointEntry", at, "upper")),
        from.getDouble(at("JointEntry", at, "velocity")),
        from.getDouble(at("JointEntry", at, "effort")));
  }

  private Board.Host host(ByteBuffer from, int at) {
    return new Board.Host(
        Memory.text(from, at("HostEntry", at, "name"), name),
        from.getInt(at("HostEntry", at, "pid")),
        Integer.toUnsignedLong(from.getInt(at("HostEntry", at, "respawns"))),
        Memory.text(from, at("HostEntry", at, "error"), text));
  }

  private Board.Plugin plugin(ByteBuffer from, int at) {
    return new Board.Plugin(
        Memory.text(from, at("PluginEntry", at, "name"), name),
        Memory.text(from, at("PluginEntry", at, "type"), name),
        from.getInt(at("PluginEntry", at, "host")),
        from.getInt(at("PluginEntry", at, "thread")),
        state(from.getInt(at("PluginEntry", at, "state"))),
        Integer.toUnsignedLong(from.getInt(at("PluginEntry", at, "respawns"))),
        from.getInt(at("PluginEntry", at, "io")) == 1,
        Memory.text(from, at("PluginEntry", at, "error"), text),
        Memory.text(from, at("PluginEntry", at, "status"), text));
  }

  private Board.Chain chain(ByteBuffer from, int at) {
    Layout.Field indices = layout.struct("ChainEntry").fields().get("joint");
    long there = Math.min(Integer.toUnsignedLong(from.getInt(at("ChainEntry", at, "joints"))), indices.count());
    List<Integer> joints = new ArrayList<>();
    for (int i = 0; i < there; i++) {
      joints.add(Short.toUnsignedInt(from.getShort(at + indices.offset() + i * indices.size())));
    }
    return new Board.Chain(Memory.text(from, at("ChainEntry", at, "name"), name), joints);
  }

  private static PluginState state(int number) {
    return number >= 0 && number < STATES.length ? STATES[number] : PluginState.FAILED;
  }
}
