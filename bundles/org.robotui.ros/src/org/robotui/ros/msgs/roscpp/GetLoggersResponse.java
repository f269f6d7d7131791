package org.robotui.ros.msgs.roscpp;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * A node's loggers ({@code roscpp/GetLoggersResponse}).
 *
 * @param loggers the loggers
 */
public record GetLoggersResponse(List<Logger> loggers) {

  /** Between records and bytes. */
  public static final RecordCodec<GetLoggersResponse> CODEC =
      RecordCodec.of("roscpp/GetLoggersResponse", GetLoggersResponse::read, GetLoggersResponse::write);

  /** Keeps immutable copies of lists. */
  public GetLoggersResponse {
    loggers = List.copyOf(loggers);
  }

  private static GetLoggersResponse read(MessageReader in) throws MessageException {
    return new GetLoggersResponse(in.list("loggers", Logger.CODEC));
  }

  private static void write(GetLoggersResponse m, MessageWriter out) {
    Logger.CODEC.encodeAll(m.loggers, out);
  }
}
