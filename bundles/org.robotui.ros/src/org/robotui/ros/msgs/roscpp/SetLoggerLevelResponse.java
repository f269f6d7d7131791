package org.robotui.ros.msgs.roscpp;

import org.robotui.ros.message.RecordCodec;

/** Says that the level was set ({@code roscpp/SetLoggerLevelResponse}). */
public record SetLoggerLevelResponse() {

  /** Between records and bytes. */
  public static final RecordCodec<SetLoggerLevelResponse> CODEC =
      RecordCodec.of("roscpp/SetLoggerLevelResponse", in -> new SetLoggerLevelResponse(), (m, out) -> { });
}
