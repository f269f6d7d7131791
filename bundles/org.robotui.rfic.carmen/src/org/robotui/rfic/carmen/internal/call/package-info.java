/** Questions to programs of CARMEN, and looking at what a central knows. */
package org.robotui.rfic.carmen.internal.call;
