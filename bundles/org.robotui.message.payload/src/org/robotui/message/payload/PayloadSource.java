package org.robotui.message.payload;

import org.robotui.net.log.PeerText;

/**
 * What a server or a recording says of some messages.
 *
 * @param encoding of the messages
 * @param type the name of their schema
 * @param schemaEncoding of the schema, may be empty
 * @param schema the schema, may be empty; in Base64 where it is no text
 */
public record PayloadSource(String encoding, String type, String schemaEncoding, String schema) {

  /** In words, for users. */
  String words() {
    return PeerText.name(type) + " in " + PeerText.name(encoding)
        + (schemaEncoding.isEmpty() ? "" : " (" + PeerText.name(schemaEncoding) + ")");
  }
}
