package org.robotui.uic.camera.internal;

import java.util.List;
import java.util.Optional;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.data.CameraInfo;
import org.robotui.data.Image;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.PictureDecoder;

/** Takes the newest picture and decodes it. Called by the tick only. */
final class CameraModel {
  private final Input<Image> input;
  private final Input<CameraInfo> info;
  private final RuicView ruic;
  private final SourceId port;
  private Optional<Envelope<Image>> newest = Optional.empty();
  private Optional<Picture> picture = Optional.empty();
  private Optional<String> broken = Optional.empty();

  CameraModel(Input<Image> input, Input<CameraInfo> info, RuicView ruic, SourceId port) {
    this.input = input;
    this.info = info;
    this.ruic = ruic;
    this.port = port;
  }

  /** What is to be shown now. */
  Shot look() {
    Optional<Envelope<Image>> latest = input.latest();
    if (latest.isPresent() && !same(latest.get())) {
      decode(latest.get());
    }
    InputState state = input.state();
    boolean unconnected = state instanceof InputState.Unconnected;
    return new Shot(broken.filter(why -> state instanceof InputState.Live).<InputState>map(InputState.Failed::new).orElse(state),
        picture, info.latest().map(Envelope::value), unconnected ? candidates() : List.of(), Optional.empty());
  }

  private boolean same(Envelope<Image> envelope) {
    return newest.filter(n -> n.value() == envelope.value()).isPresent();
  }

  private void decode(Envelope<Image> envelope) {
    newest = Optional.of(envelope);
    switch (PictureDecoder.decode(envelope.value())) {
      case Decoding.Decoded decoded -> {
        picture = Optional.of(decoded.picture());
        broken = Optional.empty();
      }
      case Decoding.Undecodable bad -> {
        picture = Optional.empty();
        broken = Optional.of(envelope.source() + ": " + bad.reason());
      }
    }
  }

  private List<SourceId> candidates() {
    return ruic.snapshot().matches().stream()
        .filter(match -> match.kind() == PortKind.STREAM && match.port().equals(port))
        .filter(match -> match.state() == MatchState.AMBIGUOUS)
        .findFirst().map(Match::candidates).orElse(List.of());
  }
}
