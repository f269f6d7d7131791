package org.robotui.ui.control;

/** Copies what was typed between parts of the same form. */
final class FormCopy {
  private FormCopy() {}

  static void copy(FormNode from, FormNode to) {
    if (from instanceof FormLeaf a && to instanceof FormLeaf b) {
      b.take(a);
    } else if (from instanceof FormGroup a && to instanceof FormGroup b) {
      for (int i = 0; i < a.fields().size(); i++) {
        copy(a.fields().get(i), b.fields().get(i));
      }
    } else if (from instanceof FormArray a && to instanceof FormArray b) {
      copy(a, b);
    }
  }

  private static void copy(FormArray from, FormArray to) {
    for (int i = 0; i < from.elements().size(); i++) {
      if (i == to.elements().size()) {
        to.add();
      }
      copy(from.elements().get(i), to.elements().get(i));
    }
  }
}
