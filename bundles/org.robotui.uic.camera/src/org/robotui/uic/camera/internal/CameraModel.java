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
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.Image;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.PictureDecoder;
import org.robotui.entity.image.Rendering;

/** Takes the newest picture and decodes it. Called by the tick only. */
final class CameraModel {
  private final Input<Image> input;
  private final Input<CameraInfo> info;
  private final RuicView ruic;
  private final SourceId port;
  private final PictureDecoder decoder = new PictureDecoder();
  private Optional<Envelope<Image>> newest = Optional.empty();
  private Optional<Rendering> rendering = Optional.empty();
  private Optional<Shot.Shown> shown = Optional.empty();
  private Optional<String> broken = Optional.empty();
  private int factor = 1;

  CameraModel(Input<Image> input, Input<CameraInfo> info, RuicView ruic, SourceId port) {
    this.input = input;
    this.info = info;
    this.ruic = ruic;
    this.port = port;
  }

  /**
   * What is to be shown now.
   *
   * @param wanted how numbers become colours
   * @param blocks edge of the blocks of pixels that become one, because the picture is seen from afar
   */
  Shot look(Rendering wanted, int blocks) {
    Optional<Envelope<Image>> latest = input.latest();
    if (latest.isPresent() && (!same(latest.get()) || !rendering.equals(Optional.of(wanted)))) {
      decode(latest.get(), wanted, blocks);
    } else if (blocks != factor) {
      shown = shown.map(s -> shown(s.picture(), newest.orElseThrow(), blocks));
    }
    factor = blocks;
    InputState state = input.state();
    boolean unconnected = state instanceof InputState.Unconnected;
    return new Shot(
        broken.filter(why -> state instanceof InputState.Live).<InputState>map(InputState.Failed::new).orElse(state),
        shown, info.latest().map(Envelope::value), unconnected ? candidates() : List.of(), Optional.empty());
  }

  private boolean same(Envelope<Image> envelope) {
    return newest.filter(n -> n.value() == envelope.value()).isPresent();
  }

  private void decode(Envelope<Image> envelope, Rendering wanted, int blocks) {
    newest = Optional.of(envelope);
    rendering = Optional.of(wanted);
    switch (decoder.decode(envelope.value(), wanted)) {
      case Decoding.Decoded decoded -> {
        shown = Optional.of(shown(decoded.picture(), envelope, blocks));
        broken = Optional.empty();
      }
      case Decoding.Undecodable bad -> {
        shown = Optional.empty();
        broken = Optional.of(envelope.source() + ": " + bad.reason());
      }
    }
  }

  private static Shot.Shown shown(Picture picture, Envelope<Image> envelope, int blocks) {
    return new Shot.Shown(
        picture, picture.shrunk(blocks), envelope.value().frame().name(), envelope.receivedNanos());
  }

  private List<SourceId> candidates() {
    return ruic.snapshot().matches().stream()
        .filter(match -> match.kind() == PortKind.STREAM && match.port().equals(port))
        .filter(match -> match.state() == MatchState.AMBIGUOUS)
        .findFirst().map(Match::candidates).orElse(List.of());
  }
}
