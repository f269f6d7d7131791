/** Messages of roblets as data types. */
package org.robotui.rfic.roblets.internal.convert;
