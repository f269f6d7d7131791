package org.robotui.rfic.foxglove.internal.payload;

import org.robotui.foxglove.ServerChannel;
import org.robotui.foxglove.Service;
import org.robotui.net.log.PeerText;

/**
 * What a server says of some messages.
 *
 * @param encoding of the messages
 * @param type the name of their schema
 * @param schemaEncoding of the schema, may be empty
 * @param schema the schema, may be empty
 */
public record PayloadSource(String encoding, String type, String schemaEncoding, String schema) {

  /**
   * Of a channel.
   *
   * @param channel a server's channel
   * @return what the server says of its messages
   */
  public static PayloadSource of(ServerChannel channel) {
    return new PayloadSource(channel.encoding(), channel.type(), channel.schemaEncoding(), channel.schema());
  }

  /**
   * Of requests or responses of a service.
   *
   * @param form what the server says of them
   * @param encoding theirs where the server does not say it, as older ones do not
   * @param type likewise
   * @return what is known of them
   */
  public static PayloadSource of(Service.Form form, String encoding, String type) {
    return new PayloadSource(form.encoding().isEmpty() ? encoding : form.encoding(),
        form.type().isEmpty() ? type : form.type(), form.schemaEncoding(), form.schema());
  }

  /** In words, for users. */
  String words() {
    return PeerText.name(type) + " in " + PeerText.name(encoding)
        + (schemaEncoding.isEmpty() ? "" : " (" + PeerText.name(schemaEncoding) + ")");
  }
}
