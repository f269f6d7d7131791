/**
 * What robots say and are told: immutable values in SI units. This package has what all of them share: how a type is
 * delivered, frames and time stamps; the types themselves lie in the packages below, by subject.
 *
 * <p>Lengths are metres, angles radians, times seconds unless a name says nanoseconds. Axes follow REP-103, frame names
 * REP-105. A value is checked when it is made: {@link java.lang.IllegalArgumentException} names the offending
 * component, so that whoever holds a value may rely on it. Places and poses are finite, no farther than 10^9 m from the
 * origin of their frame, and turned by quaternions of length 1; markers alone are kept as robots send them, for their
 * displays to say what is wrong. Types extend each other by interface; {@link org.robotui.data.DataType} tells how a
 * type is delivered.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.data;
