package org.robotui.rfic.foxglove.internal.session;

import org.robotui.foxglove.ServerChannel;
import org.robotui.foxglove.Service;
import org.robotui.message.payload.PayloadSource;

/** What a server says of its messages. */
public final class ServerSource {
  private ServerSource() {}

  static PayloadSource of(ServerChannel channel) {
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
}
