/** Messages of CARMEN as data, and back. Pure functions. */
package org.robotui.rfic.carmen.internal.convert;
