package org.robotui.lcm.type;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;

/** Brings the sizes and arrays of one record together. */
final class RecordAssembly {

  private static final int UNKNOWN = -1;

  private final Layout layout;
  private final Map<Integer, LcmValue> given;
  /** By the index of the member that is a size. */
  private final int[] sizes;

  RecordAssembly(Layout layout, Map<Integer, LcmValue> given) {
    this.layout = layout;
    this.given = given;
    this.sizes = new int[layout.slots().size()];
    Arrays.fill(sizes, UNKNOWN);
  }

  LcmRecord build() {
    takeSizes();
    for (int i = 0; i < sizes.length; i++) {
      if (layout.slots().get(i).isArray() && given.containsKey(i)) {
        learn(layout.slots().get(i), shapeOf(given.get(i)));
      }
    }
    LcmValue[] values = new LcmValue[sizes.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = value(i);
    }
    return new LcmRecord(layout, values);
  }

  private void takeSizes() {
    layout.slots().stream().flatMap(slot -> slot.extents().stream()).filter(extent -> !extent.isFixed())
        .forEach(extent -> {
          if (given.get(extent.slot()) instanceof LcmValue.Whole(long size)) {
            if (size < 0 || size > Integer.MAX_VALUE) {
              throw new IllegalArgumentException(
                  name(extent.slot()) + " is the size of an array and cannot be " + size);
            }
            sizes[extent.slot()] = (int) size;
          }
        });
  }

  /** What the array says of sizes that are not set: all of them if it has its shape, one if it is flat. */
  private void learn(Slot slot, List<Integer> shape) {
    boolean full = shape.size() == slot.extents().size();
    for (int i = 0; i < slot.extents().size(); i++) {
      Slot.Extent extent = slot.extents().get(i);
      if (!extent.isFixed() && sizes[extent.slot()] == UNKNOWN) {
        sizes[extent.slot()] = full ? shape.get(i) : rest(slot, extent.slot(), shape.getFirst());
      }
    }
  }

  private int rest(Slot slot, int wanted, int count) {
    long others = 1;
    for (Slot.Extent extent : slot.extents()) {
      if (extent.slot() != wanted || extent.isFixed()) {
        if (!extent.isFixed() && sizes[extent.slot()] == UNKNOWN) {
          throw new IllegalArgumentException("the shape of " + layout.type() + "." + slot.name() + " is open: set "
              + name(extent.slot()) + " or " + name(wanted));
        }
        others *= extent.isFixed() ? extent.size() : sizes[extent.slot()];
      }
    }
    return others == 0 ? 0 : (int) (count / others);
  }

  private LcmValue value(int index) {
    Slot slot = layout.slots().get(index);
    LcmValue value = given.get(index);
    if (slot.isArray()) {
      List<Integer> shape = slot.extents().stream()
          .map(extent -> extent.isFixed() ? extent.size() : Math.max(0, sizes[extent.slot()])).toList();
      return value == null ? Zeros.array(slot, shape) : shaped(slot, value, shape);
    }
    return sizes[index] != UNKNOWN ? size(slot, sizes[index]) : value == null ? Zeros.single(slot) : value;
  }

  private LcmValue size(Slot slot, int size) {
    return Fitting.of(slot, new LcmValue.Whole(size), layout.type());
  }

  private LcmValue shaped(Slot slot, LcmValue value, List<Integer> shape) {
    List<Integer> found = shapeOf(value);
    boolean agrees = found.equals(shape)
        || found.size() == 1
            && found.getFirst() == shape.stream().mapToLong(Integer::longValue).reduce(1, Slot::product);
    if (!agrees) {
      throw new IllegalArgumentException(
          layout.type() + "." + slot.name() + " has the shape " + found + ", and its sizes say " + shape);
    }
    return switch (value) {
      case LcmValue.Numbers(NumberArray numbers) -> new LcmValue.Numbers(
          new NumberArray(numbers.type(), numbers.bytes(), shape));
      case LcmValue.Texts texts -> new LcmValue.Texts(texts.values(), shape);
      case LcmValue.Records records -> new LcmValue.Records(records.values(), shape);
      default -> value;
    };
  }

  private static List<Integer> shapeOf(LcmValue value) {
    return switch (value) {
      case LcmValue.Numbers numbers -> numbers.value().shape();
      case LcmValue.Texts texts -> texts.shape();
      case LcmValue.Records records -> records.shape();
      default -> List.of();
    };
  }

  private String name(int slot) {
    return layout.type() + "." + layout.slots().get(slot).name();
  }

  /** What members hold that nobody set. */
  private static final class Zeros {

    static LcmValue single(Slot slot) {
      return switch (slot.element()) {
        case Slot.Struct(Layout nested) -> new LcmValue.Nested(new RecordAssembly(nested, Map.of()).build());
        case Slot.Builtin(Primitive type) -> switch (type) {
          case STRING -> new LcmValue.Text("");
          case BOOLEAN -> new LcmValue.Flag(false);
          case FLOAT, DOUBLE -> new LcmValue.Real(0);
          default -> new LcmValue.Whole(0);
        };
      };
    }

    static LcmValue array(Slot slot, List<Integer> shape) {
      int count = (int) shape.stream().mapToLong(Integer::longValue).reduce(1, Slot::product);
      return switch (slot.element()) {
        case Slot.Struct(Layout nested) -> new LcmValue.Records(
            count == 0 ? List.of() : Collections.nCopies(count, new RecordAssembly(nested, Map.of()).build()), shape);
        case Slot.Builtin(Primitive type) -> type == Primitive.STRING
            ? new LcmValue.Texts(new ArrayList<>(Collections.nCopies(count, "")), shape)
            : new LcmValue.Numbers(
                new NumberArray(type, ByteBuffer.allocate(Math.multiplyExact(count, type.size())), shape));
      };
    }
  }
}
