package org.robotui.api.port;

import org.robotui.data.Bytes;

/**
 * A message as it came, for bridges and recorders, so that nothing unknown is lost.
 *
 * @param schema the robot's name of the type
 * @param encoding how the bytes are to be read, for example {@code ros1}
 * @param bytes the bytes
 */
public record RawMessage(String schema, String encoding, Bytes bytes) {}
