package org.robotui.rfic.lcm.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.robotui.api.config.Placed;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.RecordException;
import org.robotui.lcm.type.TypeException;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.lcm.type.TypeParser;
import org.robotui.rfic.lcm.internal.convert.Reception;
import org.robotui.rfic.lcm.internal.convert.RecordFiller;
import org.robotui.rfic.lcm.internal.language.FaultException;
import org.robotui.rfic.lcm.internal.language.Values;

/** Maps messages of a type that a test declares. */
final class Mapped {
  final List<FrameTransform> transforms = new ArrayList<>();
  final TypeLibrary types;

  Mapped(TypeLibrary types) {
    this.types = types;
  }

  static Mapped declaring(String text) {
    try {
      return new Mapped(TypeLibrary.of(TypeParser.parse("test.lcm", text), List.of()));
    } catch (TypeException e) {
      throw new AssertionError(e);
    }
  }

  /** What a message becomes. */
  <D extends Data> D convert(Class<D> data, String type, Map<String, Object> fields, Object mapping)
      throws FaultException {
    LcmSettings.Stream stream =
        Written.right(Written.settings("memq://", "types", Map.of("CHANNEL", mapping), Map.of())).streams().getFirst();
    LcmType found = TypeCheck.type(Placed.nowhere(type), types);
    try {
      Values values = new Values(found.decode(found.encode(new RecordFiller(types).fill(found, fields))),
          stream.mapping().bind(found, types));
      Stamp stamp = new Stamp(values.nanos("stamp").orElse(0L), ClockKind.ROBOT);
      return data.cast(stream.shape().make().of(values,
          new Reception("robby", "CHANNEL", stamp, set -> transforms.addAll(set.transforms()))));
    } catch (RecordException e) {
      throw new AssertionError(e);
    }
  }

}
